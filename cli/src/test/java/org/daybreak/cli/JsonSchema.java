package org.daybreak.cli;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;

/**
 * Checks JSON against the part of JSON Schema that the schemas in {@code docs/schemas} use: type, properties, required,
 * additionalProperties, items, minItems, maxItems, const and oneOf.
 */
final class JsonSchema {
    private final JsonNode schema;

    private JsonSchema(JsonNode schema) {
        this.schema = schema;
    }

    static JsonSchema read(String name) throws IOException {
        Path file = Path.of(System.getProperty("daybreak.root"), "docs", "schemas", name);
        return new JsonSchema(new ObjectMapper().readTree(file.toFile()));
    }

    /** All that is wrong; empty if nothing is. */
    List<String> problems(JsonNode value) {
        List<String> problems = new ArrayList<>();
        check(schema, value, "$", problems);
        return problems;
    }

    private static void check(JsonNode rule, JsonNode value, String at, List<String> problems) {
        JsonNode type = rule.get("type");
        if (type != null && !hasType(type, value)) {
            problems.add(at + " is " + value + " but must be " + type);
            return;
        }
        if (rule.has("const") && !rule.get("const").equals(value)) {
            problems.add(at + " is " + value + " but must be " + rule.get("const"));
        }
        if (rule.has("oneOf")) {
            int matches = 0;
            List<String> all = new ArrayList<>();
            for (JsonNode choice : rule.get("oneOf")) {
                List<String> own = new ArrayList<>();
                check(choice, value, at, own);
                matches += own.isEmpty() ? 1 : 0;
                all.addAll(own);
            }
            if (matches != 1) {
                problems.add(at + " matches " + matches + " choices: " + all);
            }
        }
        if (value.isObject()) {
            checkObject(rule, value, at, problems);
        } else if (value.isArray()) {
            int size = value.size();
            if (size < rule.path("minItems").asInt(0)
                    || size > rule.path("maxItems").asInt(Integer.MAX_VALUE)) {
                problems.add(at + " has " + size + " items");
            }
            for (int i = 0; i < size && rule.has("items"); i++) {
                check(rule.get("items"), value.get(i), at + "[" + i + "]", problems);
            }
        }
    }

    private static void checkObject(JsonNode rule, JsonNode value, String at, List<String> problems) {
        for (JsonNode name : rule.path("required")) {
            if (!value.has(name.asText())) {
                problems.add(at + " has no " + name);
            }
        }
        JsonNode others = rule.get("additionalProperties");
        for (Map.Entry<String, JsonNode> field : value.properties()) {
            String place = at + "." + field.getKey();
            JsonNode own = rule.path("properties").get(field.getKey());
            if (own != null) {
                check(own, field.getValue(), place, problems);
            } else if (others != null && others.isObject()) {
                check(others, field.getValue(), place, problems);
            } else if (others != null && !others.asBoolean()) {
                problems.add(place + " is not in the schema");
            }
        }
    }

    private static boolean hasType(JsonNode types, JsonNode value) {
        if (types.isArray()) {
            for (JsonNode type : types) {
                if (hasType(type, value)) {
                    return true;
                }
            }
            return false;
        }
        return switch (types.asText()) {
            case "object" -> value.isObject();
            case "array" -> value.isArray();
            case "string" -> value.isTextual();
            case "boolean" -> value.isBoolean();
            case "integer" -> value.isIntegralNumber();
            case "number" -> value.isNumber();
            case "null" -> value.isNull();
            default -> throw new IllegalArgumentException("unknown type " + types);
        };
    }
}
