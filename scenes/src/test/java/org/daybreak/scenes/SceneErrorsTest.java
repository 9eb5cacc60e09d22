package org.daybreak.scenes;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeFalse;
import static org.junit.jupiter.params.provider.Arguments.arguments;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.daybreak.scenes.description.ProblemList;
import org.daybreak.scenes.description.SceneException;
import org.daybreak.scenes.description.SceneProblem;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

class SceneErrorsTest {
    @TempDir
    Path folder;

    /** Content of a scene with § where the only error is, and a part of its message. */
    static Stream<Arguments> contents() {
        return Stream.of(
                arguments("§<shap type='sphere'/>", "unknown element <shap>; did you mean 'shape'?"),
                arguments(
                        "<shape type='sphere'>\n  <!-- < -->§<flot name='radius' value='2'/></shape>",
                        "unknown element <flot>; did you mean 'float'?"),
                arguments("§<shape type='sphere' colour='red'/>", "<shape> has no attribute 'colour'"),
                arguments("§<shape type='spher'/>", "shape type 'spher' is not supported; did you mean 'sphere'?"),
                arguments("§<integrator type='pth'/>", "integrator type 'pth' is not supported; did you mean 'path'?"),
                arguments("§<shape/>", "<shape> needs the attribute 'type'"),
                arguments(
                        "<bsdf type='diffuse'>§<rgb name='reflectence' value='1'/></bsdf>",
                        "<bsdf type=\"diffuse\"> has no property 'reflectence'; did you mean 'reflectance'?"),
                arguments("§<shape type='obj'/>", "<shape type=\"obj\"> needs the property 'filename'"),
                arguments(
                        "<shape type='sphere'>§<string name='radius' value='2'/></shape>",
                        "'radius' of <shape type=\"sphere\"> must be a float greater than 0 but is a string"),
                arguments(
                        "<shape type='sphere'>§<float name='radius' value='0'/></shape>", "greater than 0 but is 0.0"),
                arguments(
                        "<shape type='sphere'>§<float name='radius' value='nan'/></shape>",
                        "'nan' is not a finite number"),
                arguments(
                        "<shape type='sphere'>§<float name='radius' value='1e999'/></shape>",
                        "'1e999' is not a finite number"),
                arguments(
                        "<shape type='sphere'>§<float name='radius' value='1f'/></shape>",
                        "'1f' is not a finite number"),
                arguments(
                        "<shape type='sphere'>§<float name='radius'/></shape>", "<float> needs the attribute 'value'"),
                arguments(
                        "<shape type='sphere'><float name='radius' value='1'/>§<float name='radius' value='2'/></shape>",
                        "'radius' is given twice"),
                arguments(
                        "<shape type='sphere'>§<boolean name='flip_normals' value='yes'/></shape>",
                        "neither true nor false"),
                arguments(
                        "<shape type='sphere'>§<point name='center' x='1' y='2'/></shape>",
                        "needs the attribute 'value' or"),
                arguments(
                        "<shape type='sphere'>§<point name='center' value='1, 2'/></shape>",
                        "'1, 2' must be one or three numbers"),
                arguments(
                        "<shape type='sphere'>§<ref id='wod'/></shape><bsdf type='diffuse' id='wood'/>",
                        "did you mean 'wood'?"),
                arguments(
                        "<shape type='sphere'>§<ref id='t'/></shape><texture type='checkerboard' id='t'/>",
                        "<shape type=\"sphere\"> cannot contain a <texture>"),
                arguments(
                        "<shape type='sphere'><bsdf type='diffuse'/>§<bsdf type='diffuse'/></shape>",
                        "must contain at most one <bsdf>"),
                arguments(
                        "<bsdf type='diffuse' id='a'/>\n§<bsdf type='plastic' id='a'/>",
                        "the id 'a' is already taken at"),
                arguments("<bsdf type='twosided' id='a'>§<ref id='a'/></bsdf>", "contains itself"),
                arguments("§<bsdf type='twosided'/>", "must contain 1 to 2 <bsdf>"),
                arguments(
                        "<bsdf type='twosided'>§<bsdf type='dielectric'/></bsdf>", "opaque materials, not dielectric"),
                arguments(
                        "<bsdf type='mask'>§<float name='opacity' value='2'/><bsdf type='diffuse'/></bsdf>",
                        "contains 2.0"),
                arguments("<bsdf type='diffuse'>§<rgb name='reflectance' value='1,1,1.5'/></bsdf>", "contains 1.5"),
                arguments(
                        "<bsdf type='diffuse'>§<rgb name='reflectance' value='1,1'/></bsdf>",
                        "must be one or three numbers"),
                arguments(
                        "<bsdf type='diffuse'>§<rgb name='reflectance' value='#12345'/></bsdf>",
                        "is not a colour like"),
                arguments(
                        "<bsdf type='diffuse'>§<spectrum name='reflectance' value='700:1, 400:0.5'/></bsdf>",
                        "the wavelengths of a spectrum must ascend"),
                arguments(
                        "<bsdf type='diffuse'>§<spectrum name='reflectance' value='400:1'/></bsdf>",
                        "at least 2 but has 1 wavelengths"),
                arguments(
                        "<bsdf type='diffuse'>§<spectrum name='reflectance' value='1, 2, 3'/></bsdf>",
                        "'1, 2, 3' is not a finite number"),
                arguments(
                        "<bsdf type='diffuse'>§<spectrum name='reflectance' filename='no.spd'/></bsdf>",
                        "cannot read the spectrum"),
                arguments(
                        "<emitter type='constant'>§<spectrum name='radiance' type='blackbodi'/></emitter>",
                        "did you mean 'blackbody'?"),
                arguments("<bsdf type='diffuse'>§<texture type='checkerboard'/></bsdf>", "needs a name: reflectance"),
                arguments(
                        "<bsdf type='diffuse'>§<texture name='reflectance' type='checkerboard'>"
                                + "<rgb name='color1' value='3'/></texture></bsdf>",
                        "must not exceed 1 but its texture reaches 3"),
                arguments(
                        "<bsdf type='roughplastic'>§<texture name='alpha' type='checkerboard'/></bsdf>",
                        "but is a texture"),
                arguments(
                        "<bsdf type='conductor'>§<string name='material' value='Aul'/></bsdf>",
                        "there is no metal 'Aul' (give 'eta' and 'k' for others); did you mean 'Al'"),
                arguments(
                        "<bsdf type='conductor'>§<string name='material' value='Au'/><rgb name='k' value='1'/></bsdf>",
                        "not both"),
                arguments(
                        "<bsdf type='roughconductor'><float name='alpha' value='0.1'/>"
                                + "§<float name='alpha_u' value='0.1'/><float name='alpha_v' value='0.2'/></bsdf>",
                        "not both"),
                arguments(
                        "<bsdf type='principled'>§<float name='eta' value='1.5'/>"
                                + "<float name='specular' value='0.5'/></bsdf>",
                        "either 'eta' or 'specular'"),
                arguments(
                        "<bsdf type='principled'>§<float name='roughness' value='1.5'/></bsdf>",
                        "a float or a texture with values from 0 to 1"),
                arguments(
                        "§<bsdf type='roughdielectric'><float name='int_ior' value='1.5'/>"
                                + "<float name='ext_ior' value='1.5'/></bsdf>",
                        "must differ"),
                arguments(
                        "§<bsdf type='leaf'><float name='reflectance' value='0.7'/></bsdf>",
                        "front reflectance and transmittance must not exceed 1 together"),
                arguments("§<bsdf type='blendbsdf'><bsdf type='diffuse'/></bsdf>", "must contain exactly 2 <bsdf>"),
                arguments(
                        "<bsdf type='bumpmap'><texture type='mesh_attribute'>§<string name='name' value='x'/>"
                                + "</texture><bsdf type='diffuse'/></bsdf>",
                        "only mesh attribute"),
                arguments("<bsdf type='roughconductor'>§<float name='alpha_u' value='0.1'/></bsdf>", "given together"),
                arguments(
                        "<bsdf type='roughconductor'>§<string name='distribution' value='phong'/></bsdf>",
                        "must be one of beckmann, ggx but is 'phong'"),
                arguments(
                        "<bsdf type='dielectric'>§<string name='int_ior' value='diamon'/></bsdf>",
                        "did you mean 'diamond'?"),
                arguments("<bsdf type='dielectric'>§<float name='ext_ior' value='-1'/></bsdf>", "but is -1.0"),
                arguments("<shape type='sphere'>§<emitter type='point'/></shape>", "a shape can only contain"),
                arguments("§<emitter type='area'/>", "must stand in a shape"),
                arguments(
                        "<shape type='sphere'><emitter type='area'>§<rgb name='radiance' value='1,-1,1'/></emitter></shape>",
                        "not negative but contains -1.0"),
                arguments(
                        "<emitter type='point'>§<point name='position' value='1,2,3'/>"
                                + "<transform name='to_world'/></emitter>",
                        "either 'position' or 'to_world'"),
                arguments("<emitter type='spot'>§<float name='beam_width' value='30'/></emitter>", "must not exceed"),
                arguments(
                        "<shape type='sphere'>§<transform name='to_world'><scale x='0'/></transform></shape>",
                        "singular"),
                arguments(
                        "<shape type='sphere'>§<transform name='to_world'>"
                                + "<matrix value='1 2 3 0 2 4 6 0 0 0 1 0 0 0 0 1'/></transform></shape>",
                        "singular"),
                arguments(
                        "<shape type='sphere'>§<transform name='to_world'>"
                                + "<matrix value='1 0 0 0 0 1 0 0 0 0 1 0 0 0 1 1'/></transform></shape>",
                        "projective"),
                arguments(
                        "<shape type='sphere'><transform name='to_world'>§<matrix value='1 2'/></transform></shape>",
                        "a matrix must have 9 or 16 numbers but has 2"),
                arguments(
                        "<shape type='sphere'><transform name='to_world'>§<rotate angle='3'/></transform></shape>",
                        "axis"),
                arguments(
                        "<shape type='sphere'><transform name='to_world'>§<rotat angle='3'/></transform></shape>",
                        "did you mean 'rotate'?"),
                arguments(
                        "<shape type='sphere'><transform name='to_world'>"
                                + "§<lookat origin='0,0,0' target='0,2,0' up='0,1,0'/></transform></shape>",
                        "parallel"),
                arguments("§<translate x='1'/>", "can only stand in <transform>"),
                arguments("<shape type='sphere'>§<float name='radius' value='$r'/></shape>", "'$r' is not defined"),
                arguments("§<include filename='missing.xml'/>", "the file does not exist"),
                arguments("§<include filename='scene.xml'/>", "the file includes itself"),
                arguments(
                        "<shape type='obj'>§<string name='filename' value='no.obj'/></shape>", "no.obj does not exist"),
                arguments("<shape type='obj'>§<string name='filename' value='.'/></shape>", "is a directory"),
                arguments(
                        "<shape type='obj'>§<string name='filename' value=''/></shape>",
                        "must be a file name but is empty"),
                arguments(
                        "<shape type='instance'>§<ref id='s'/></shape><shape type='sphere' id='s'/>",
                        "must contain a shapegroup"),
                arguments(
                        "<integrator type='path'>§<integer name='max_depth' value='0'/></integrator>",
                        "at least 1 but is 0"),
                arguments(
                        "<integrator type='path'>§<integer name='max_depth' value='-2'/></integrator>",
                        "at least -1 but is -2"),
                arguments(
                        "<integrator type='path'>§<float name='max_depth' value='3'/></integrator>", "but is a float"),
                arguments(
                        "<integrator type='mlt'>§<integer name='direct_samples' value='0'/></integrator>",
                        "'direct_samples' must be -1 for leaving direct light to the chains or at least 1 but is 0"),
                arguments(
                        "§<integrator type='mlt'><boolean name='bidirectional_mutation' value='false'/>"
                                + "<boolean name='lens_perturbation' value='false'/>"
                                + "<boolean name='caustic_perturbation' value='false'/>"
                                + "<boolean name='multi_chain_perturbation' value='false'/></integrator>",
                        "all mutation strategies are switched off"),
                arguments(
                        "<integrator type='mlt'>§<boolean name='caustic_mutation' value='false'/></integrator>",
                        "has no property 'caustic_mutation'; did you mean 'caustic_perturbation'"),
                arguments(
                        "<integrator type='pssmlt'>§<float name='p_large' value='2'/></integrator>",
                        "'p_large' of <integrator type=\"pssmlt\"> must be a float from 0 to 1 but is 2.0"),
                arguments(
                        "<integrator type='pssmlt'>§<float name='mutation_size_low' value='0.1'/></integrator>",
                        "'mutation_size_low' is 0.1 but must be at most 'mutation_size_high', which is 0.015625"),
                arguments(
                        "<shape type='sphere'><bsdf type='diffuse'/>§<film type='hdrfilm'/></shape>",
                        "cannot contain a <film>"));
    }

    @ParameterizedTest
    @MethodSource("contents")
    void namesThePlaceOfAnError(String marked, String message) throws IOException {
        String text = SceneTexts.scene(marked);
        List<SceneProblem> errors = SceneTexts.errors(folder, text.replace("§", ""));
        assertEquals(1, errors.size(), errors::toString);
        SceneProblem error = errors.get(0);
        assertEquals(
                SceneTexts.marks(text),
                List.of(error.location().line() + ":" + error.location().column()),
                error::toString);
        assertTrue(error.message().contains(message), error::toString);
    }

    @Test
    void countsLinesAsXmlDoes() throws IOException {
        String text = "<scene version='3.0.0'>\r\n<foo/>\r<foo a='>\n'/>\n\r\n  <foo/>\r\r <!--\r\n--><foo/></scene>\r";
        assertEquals(
                List.of("2:1", "3:1", "6:3", "9:4"),
                SceneTexts.errors(folder, text).stream()
                        .filter(error -> error.message().startsWith("unknown element"))
                        .map(error ->
                                error.location().line() + ":" + error.location().column())
                        .toList());
    }

    @Test
    void reportsAllErrorsOfAllFilesInOneRun() throws IOException {
        SceneTexts.write(folder, "parts/part.xml", "<scene version='3.0.0'>\n <bsdf type='difuse'/>\n</scene>");
        SceneTexts.write(folder, "bad.obj", "v 0 0 0\nv 1 0 nan\nv 0 1 0\nf 1 2 3\n");
        String marked = SceneTexts.scene(
                "<include filename='parts/part.xml'/>\n§<foo/>\n<shape type='sphere'>§<float name='radus' value='1'/>\n"
                        + "§<ref id='x'/></shape><shape type='obj'><string name='filename' value='bad.obj'/></shape>");
        List<String> errors = SceneTexts.errors(folder, marked.replace("§", "")).stream()
                .map(SceneProblem::toString)
                .toList();
        assertEquals(5, errors.size(), errors::toString);
        for (String place : SceneTexts.marks(marked)) {
            assertTrue(errors.stream().anyMatch(e -> e.contains("scene.xml:" + place + ": ")), errors::toString);
        }
        assertTrue(errors.stream().anyMatch(e -> e.contains("part.xml:2:2: bsdf type 'difuse'")), errors::toString);
        assertTrue(errors.stream().anyMatch(e -> e.contains("bad.obj:2: z of a vertex 'nan'")), errors::toString);
    }

    @Test
    void messageListsOneErrorPerLine() throws IOException {
        Path file = SceneTexts.write(folder, "scene.xml", SceneTexts.scene("<foo/>\n<bar/>"));
        SceneException e = assertThrows(SceneException.class, () -> new SceneReader().load(file, Map.of()));
        assertEquals(2, e.problems().size());
        assertEquals(2, String.valueOf(e.getMessage()).lines().count());
    }

    static Stream<Arguments> files() {
        return Stream.of(
                arguments("", ": the file is empty"),
                arguments("  \n\n", ": the file is empty"),
                arguments(
                        "<scene version='3.0.0'>\n" + SceneTexts.LIGHT + "</scene>",
                        ":1:1: <scene> must contain at least 1 <sensor>"),
                arguments(
                        "\n <sensor type='perspective'/>",
                        ":2:2: the root of a scene file must be <scene> but is <sensor>"),
                arguments("<scene version='3.0.0'>\n<film type='hdrfilm'></b>\n</scene>", "the XML is not well-formed"),
                arguments("hello", "the XML is not well-formed"),
                arguments(
                        "<scene version='x'>" + SceneTexts.SENSOR + "</scene>",
                        ":1:1: the version 'x' is not of the form"),
                arguments(
                        "<?xml version='1.0' encoding='latin-9000'?><scene version='3.0.0'/>",
                        ": the encoding 'latin-9000' is not known"));
    }

    @ParameterizedTest
    @MethodSource("files")
    void namesWhatIsWrongWithAFile(String text, String message) throws IOException {
        List<SceneProblem> errors = SceneTexts.errors(folder, text);
        assertEquals(1, errors.size(), errors::toString);
        assertTrue(errors.get(0).toString().contains(message), errors::toString);
    }

    @Test
    void refusesBytesThatAreNoText() throws IOException {
        Path file = folder.resolve("scene.xml");
        Files.write(file, new byte[] {'<', (byte) 0xff, (byte) 0xfe, 0, 1});
        SceneException e = assertThrows(SceneException.class, () -> new SceneReader().load(file, Map.of()));
        assertTrue(String.valueOf(e.getMessage()).contains("is not valid UTF-8 text"), e::getMessage);
    }

    @Test
    void refusesADirectoryAndAMissingFile() {
        SceneException e = assertThrows(SceneException.class, () -> new SceneReader().load(folder, Map.of()));
        assertTrue(String.valueOf(e.getMessage()).endsWith("this is a directory, not a scene file"), e::getMessage);
        Path missing = folder.resolve("no.xml");
        e = assertThrows(SceneException.class, () -> new SceneReader().load(missing, Map.of()));
        assertTrue(String.valueOf(e.getMessage()).endsWith("no.xml: the file does not exist"), e::getMessage);
    }

    @Test
    void refusesAnUnreadableFile() throws IOException {
        Path file = SceneTexts.write(folder, "scene.xml", SceneTexts.scene(""));
        Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("---------"));
        assumeFalse(Files.isReadable(file), "the superuser can read everything");
        SceneException e = assertThrows(SceneException.class, () -> new SceneReader().load(file, Map.of()));
        assertTrue(String.valueOf(e.getMessage()).endsWith("permission denied"), e::getMessage);
    }

    @Test
    void refusesEntityBombsAtOnce() throws IOException {
        StringBuilder bomb = new StringBuilder("<?xml version='1.0'?>\n<!DOCTYPE scene [\n<!ENTITY a0 'ha'>\n");
        for (int i = 1; i < 40; i++) {
            bomb.append("<!ENTITY a")
                    .append(i)
                    .append(" '")
                    .append(("&a" + (i - 1) + ";").repeat(10))
                    .append("'>\n");
        }
        bomb.append("]>\n<scene version='3.0.0'><string name='x' value='&a39;'/></scene>");
        List<SceneProblem> errors =
                assertTimeoutPreemptively(Duration.ofSeconds(10), () -> SceneTexts.errors(folder, bomb.toString()));
        assertEquals(1, errors.size(), errors::toString);
        assertTrue(
                errors.get(0).toString().endsWith("scene.xml:2:1: a document type (DOCTYPE) is not allowed"),
                errors::toString);
    }

    @Test
    void refusesExternalEntities() throws IOException {
        SceneTexts.write(folder, "secret.txt", "secret");
        List<SceneProblem> errors = SceneTexts.errors(
                folder, "<!DOCTYPE scene [<!ENTITY e SYSTEM 'secret.txt'>]><scene version='3.0.0'>&e;</scene>");
        assertEquals(1, errors.size(), errors::toString);
        assertTrue(
                errors.get(0).toString().endsWith("scene.xml:1:1: a document type (DOCTYPE) is not allowed"),
                errors::toString);
    }

    @Test
    void refusesDefinitionBombsAtOnce() throws IOException {
        StringBuilder bomb = new StringBuilder("<default name='a0' value='1111111111'/>");
        for (int i = 1; i < 40; i++) {
            bomb.append("\n<default name='a")
                    .append(i)
                    .append("' value='")
                    .append(("$a" + (i - 1)).repeat(10))
                    .append("'/>");
        }
        List<SceneProblem> errors = assertTimeoutPreemptively(
                Duration.ofSeconds(10), () -> SceneTexts.errors(folder, SceneTexts.scene(bomb.toString())));
        assertTrue(errors.get(0).message().contains("an attribute is longer than"), errors::toString);
    }

    @Test
    void refusesDeepNestingAndDeepInclusion() throws IOException {
        List<SceneProblem> errors = SceneTexts.errors(
                folder, SceneTexts.scene("<bsdf type='twosided'>".repeat(100_000) + "</bsdf>".repeat(100_000)));
        assertEquals(1, errors.size(), errors::toString);
        assertTrue(errors.get(0).message().contains("nested more than 64 levels"), errors::toString);
        for (int i = 0; i < 30; i++) {
            SceneTexts.write(
                    folder, i + ".xml", "<scene version='3.0.0'><include filename='" + (i + 1) + ".xml'/></scene>");
        }
        errors = SceneTexts.errors(folder, SceneTexts.scene("<include filename='0.xml'/>"));
        assertEquals(1, errors.size(), errors::toString);
        assertTrue(errors.get(0).toString().contains("more than 16 levels deep"), errors::toString);
    }

    @Test
    void refusesLongChainsOfReferences() throws IOException {
        StringBuilder chain = new StringBuilder();
        for (int i = 0; i < 50_000; i++) {
            chain.append("<bsdf type='twosided' id='b")
                    .append(i)
                    .append("'><ref id='b")
                    .append(i + 1)
                    .append("'/></bsdf>\n");
        }
        chain.append("<bsdf type='diffuse' id='b50000'/>");
        List<SceneProblem> errors = SceneTexts.errors(folder, SceneTexts.scene(chain.toString()));
        assertTrue(errors.get(0).message().contains("nested more than 64 levels"), errors::toString);
        assertEquals(ProblemList.LISTED_ERRORS + 1, errors.size());
        assertTrue(errors.get(errors.size() - 1).message().endsWith("further errors are not listed"));
    }

    @Test
    void refusesFilmsWithoutPixelsAndBadCrops() throws IOException {
        String film = "<scene version='3.0.0'>" + SceneTexts.LIGHT
                + "<sensor type='perspective'>§<film type='hdrfilm'>%s</film></sensor></scene>";
        String zero = String.format(film, "<integer name='width' value='0'/>");
        List<SceneProblem> errors = SceneTexts.errors(folder, zero.replace("§", ""));
        assertEquals(1, errors.size(), errors::toString);
        assertTrue(errors.get(0)
                .message()
                .contains("'width' of <film type=\"hdrfilm\"> must be an integer from 1 to 65536 but is 0"));
        String crop = String.format(
                film,
                "<integer name='width' value='10'/><integer name='height' value='10'/>"
                        + "<integer name='crop_offset_x' value='3'/>");
        errors = SceneTexts.errors(folder, crop.replace("§", ""));
        assertEquals(1, errors.size(), errors::toString);
        assertTrue(errors.get(0).toString().contains(SceneTexts.marks(crop).get(0) + ": the crop"), errors::toString);
    }

    static Stream<Arguments> sensors() {
        return Stream.of(
                arguments("<float name='fov' value='40'/>§<string name='focal_length' value='50mm'/>", "not both"),
                arguments("§<string name='focal_length' value='big'/>", "positive length like 50mm"),
                arguments("§<string name='fov_axis' value='y'/>", "no meaning without 'fov'"),
                arguments("§<float name='fov' value='180'/>", "but is 180"),
                arguments("§<transform name='to_world'><scale value='2'/></transform>", "must not scale or shear"),
                arguments("§<float name='principal_point_offset_x' value='1000'/>", "from -100 to 100 but is 1000.0"),
                arguments(
                        "<film type='hdrfilm'>§<rfilter type='sinc'/></film>", "rfilter type 'sinc' is not supported"),
                arguments(
                        "<film type='hdrfilm'><rfilter type='mitchell'>§<float name='C' value='0.5'/></rfilter></film>",
                        "C = (1 - B) / 2"));
    }

    @ParameterizedTest
    @MethodSource("sensors")
    void namesErrorsOfSensors(String marked, String message) throws IOException {
        String text = "<scene version='3.0.0'>\n" + SceneTexts.LIGHT + "<sensor type='perspective'>" + marked
                + "</sensor></scene>";
        List<SceneProblem> errors = SceneTexts.errors(folder, text.replace("§", ""));
        assertEquals(1, errors.size(), errors::toString);
        assertTrue(
                errors.get(0)
                        .toString()
                        .contains("scene.xml:" + SceneTexts.marks(text).get(0) + ": "),
                errors::toString);
        assertTrue(errors.get(0).message().contains(message), errors::toString);
    }

    @Test
    void reportsUnusedDefinitions() throws IOException {
        Path file = SceneTexts.write(
                folder,
                "scene.xml",
                SceneTexts.scene("<default name='radius' value='1'/>"
                        + "<shape type='sphere'><float name='radius' value='$radius'/></shape>"));
        SceneException e = assertThrows(SceneException.class, () -> new SceneReader().load(file, Map.of("radus", "2")));
        assertTrue(
                String.valueOf(e.getMessage())
                        .contains("no attribute uses the definition 'radus'; did you mean 'radius'?"),
                e::getMessage);
    }
}
