package org.daybreak.scenes.gltf;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Base64;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Edits a sound scene as arbitrary bytes say, so that what comes out is mostly well-formed. A recipe is a byte, which is odd
 * for binary files, and any number of edits of four bytes each: what to do, the place, and with what.
 */
final class GltfRecipe {
    static final Pattern TOKEN = Pattern.compile("-?[0-9][0-9.eE+-]*|true|false|\"[A-Za-z_0-9]*\"|[\\[\\]{},:]");
    static final List<String> HOSTILE = List.of(
            "0",
            "-1",
            "1",
            "3",
            "0.5",
            "255",
            "2147483647",
            "2147483648",
            "1e9",
            "1e308",
            "1e999",
            "-1e-300",
            "null",
            "true",
            "\"\"",
            "\"POSITION\"",
            "\"MASK\"",
            "[]",
            "{}",
            "[0]",
            "{\"index\":0}",
            "{\"extensions\":{}}");

    private static final int EDIT_BYTES = 4;
    private static final int MOST_EDITS = 32;
    private static final String MARK = "@";

    private static final Scene TEXT = new Scene(",\"uri\":\"" + MARK + "\"");
    private static final Scene BINARY = new Scene("");

    private GltfRecipe() {}

    /** The scene that is edited. */
    private static final class Scene {
        private final List<String> tokens = new ArrayList<>();
        /** What stands in front of each token, and behind the last one. */
        private final List<String> rest = new ArrayList<>();

        private final byte[] buffer;

        Scene(String uri) {
            GltfText scene = GltfText.everything();
            buffer = scene.buffer();
            String json = scene.json(uri);
            Matcher token = TOKEN.matcher(json);
            int end = 0;
            while (token.find()) {
                rest.add(json.substring(end, token.start()));
                tokens.add(token.group());
                end = token.end();
            }
            rest.add(json.substring(end));
        }

        String json(List<String> edited) {
            StringBuilder json = new StringBuilder();
            for (int i = 0; i < edited.size(); i++) {
                json.append(rest.get(i)).append(edited.get(i));
            }
            return json.append(rest.get(edited.size())).toString();
        }
    }

    /** The file for a recipe. */
    static byte[] file(byte[] recipe) {
        boolean binary = recipe.length > 0 && recipe[0] % 2 != 0;
        Scene scene = binary ? BINARY : TEXT;
        List<String> tokens = new ArrayList<>(scene.tokens);
        byte[] buffer = scene.buffer.clone();
        int edits = Math.min(MOST_EDITS, (recipe.length - 1) / EDIT_BYTES);
        for (int i = 0; i < edits; i++) {
            int at = 1 + EDIT_BYTES * i;
            int place = (recipe[at + 1] & 0xff) << 8 | (recipe[at + 2] & 0xff);
            int with = recipe[at + 3] & 0xff;
            int token = place % tokens.size();
            switch (recipe[at] & 3) {
                case 0 -> tokens.set(token, HOSTILE.get(with % HOSTILE.size()));
                case 1 -> tokens.set(token, scene.tokens.get((token + with + 1) % tokens.size()));
                case 2 -> tokens.set(token, "");
                default -> buffer[place % buffer.length] = (byte) with;
            }
        }
        String json = scene.json(tokens);
        if (binary) {
            return GltfText.binary(json, buffer);
        }
        String data =
                "data:application/octet-stream;base64," + Base64.getEncoder().encodeToString(buffer);
        return json.replace(MARK, data).getBytes(StandardCharsets.UTF_8);
    }
}
