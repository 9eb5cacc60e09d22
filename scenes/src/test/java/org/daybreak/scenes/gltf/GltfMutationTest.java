package org.daybreak.scenes.gltf;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.regex.Matcher;
import org.daybreak.scenes.SceneReader;
import org.daybreak.scenes.description.SceneException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Whatever is in a file: it is read, or it is refused with the exception of scene files. Seeds are fixed. */
class GltfMutationTest {
    private static final int MUTATIONS = 2000;

    @TempDir
    Path folder;

    private final GltfText scene = GltfText.everything();

    /** True if the file is refused. */
    private boolean refused(byte[] bytes, String name) throws IOException {
        Path file = Files.write(folder.resolve(name), bytes);
        try {
            // Seconds, where reading takes milliseconds: this catches what would never end.
            assertTimeoutPreemptively(Duration.ofSeconds(60), () -> new SceneReader().load(file, Map.of()));
            return false;
        } catch (AssertionError e) {
            throw e;
        } catch (Throwable e) {
            assertEquals(SceneException.class, e.getClass(), () -> new String(bytes, StandardCharsets.ISO_8859_1));
            String message = String.valueOf(e.getMessage());
            assertTrue(message.startsWith(file.toString()), message);
            assertFalse(message.contains("Exception"), message);
            return true;
        }
    }

    private static void assertSome(int refused) {
        assertTrue(refused > MUTATIONS / 8 && refused < MUTATIONS, "refused: " + refused);
    }

    @Test
    void theSceneItselfIsRead() throws IOException {
        assertFalse(refused(scene.text().getBytes(StandardCharsets.UTF_8), "a.gltf"));
        assertFalse(refused(scene.binary(), "a.glb"));
    }

    @Test
    void editsOfTheJson() throws IOException {
        String text = scene.text();
        List<int[]> tokens = new ArrayList<>();
        Matcher matcher = GltfRecipe.TOKEN.matcher(text);
        while (matcher.find()) {
            tokens.add(new int[] {matcher.start(), matcher.end()});
        }
        SplittableRandom random = new SplittableRandom(11);
        int refused = 0;
        for (int i = 0; i < MUTATIONS; i++) {
            int[] token = tokens.get(random.nextInt(tokens.size()));
            int[] other = tokens.get(random.nextInt(tokens.size()));
            String replacement = random.nextInt(4) == 0
                    ? text.substring(other[0], other[1])
                    : GltfRecipe.HOSTILE.get(random.nextInt(GltfRecipe.HOSTILE.size()));
            String edited = text.substring(0, token[0]) + replacement + text.substring(token[1]);
            refused += refused(edited.getBytes(StandardCharsets.UTF_8), "a.gltf") ? 1 : 0;
        }
        assertSome(refused);
    }

    @Test
    void bytesOfABinaryFile() throws IOException {
        byte[] good = scene.binary();
        SplittableRandom random = new SplittableRandom(12);
        int refused = 0;
        for (int i = 0; i < MUTATIONS; i++) {
            byte[] bytes = good.clone();
            int flips = 1 + random.nextInt(4);
            for (int f = 0; f < flips; f++) {
                bytes[random.nextInt(bytes.length)] ^= (byte) (1 << random.nextInt(8));
            }
            if (random.nextInt(20) == 0) {
                bytes = java.util.Arrays.copyOf(bytes, random.nextInt(bytes.length));
            }
            refused += refused(bytes, "a.glb") ? 1 : 0;
        }
        assertSome(refused);
    }

    /** Only numbers of the buffer: positions, indices, joints and weights of any value. */
    @Test
    void numbersOfTheBuffer() throws IOException {
        byte[] good = scene.binary();
        ByteBuffer view = ByteBuffer.wrap(good).order(ByteOrder.LITTLE_ENDIAN);
        int start = 28 + view.getInt(12);
        SplittableRandom random = new SplittableRandom(13);
        int refused = 0;
        for (int i = 0; i < MUTATIONS; i++) {
            byte[] bytes = good.clone();
            int at = start + random.nextInt(bytes.length - start - 4);
            ByteBuffer.wrap(bytes).putInt(at, random.nextInt());
            refused += refused(bytes, "a.glb") ? 1 : 0;
        }
        assertTrue(refused > 0 && refused < MUTATIONS, "refused: " + refused);
    }
}
