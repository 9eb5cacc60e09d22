package org.daybreak.cli;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.daybreak.core.film.FilmImage;
import org.daybreak.core.render.ImageSheet;
import org.daybreak.core.render.Parameter;
import org.daybreak.core.render.ParameterValues;
import org.daybreak.core.render.RendererFactory;
import org.daybreak.exr.ExrAttribute;
import org.daybreak.exr.ExrWriter;
import org.daybreak.exr.ImageFileException;

/**
 * A folder for the images that a renderer makes besides the film's: an OpenEXR file with a layer for each, and a page with all of
 * them small.
 *
 * @param parameter name of the renderer's parameter that asks for them; also of the files
 * @param folder where; made if it is not there
 */
record SheetFolder(String parameter, Path folder) {
    /** The folders that parameters ask for; {@link ExitCode#USAGE} if a name is none. */
    static List<SheetFolder> of(RendererFactory factory, ParameterValues values) {
        List<SheetFolder> folders = new ArrayList<>();
        for (Parameter parameter : factory.parameters()) {
            if (parameter.type() == Parameter.Type.FOLDER) {
                String name = values.folder(parameter.name());
                if (!name.isEmpty()) {
                    try {
                        folders.add(new SheetFolder(parameter.name(), Path.of(name)));
                    } catch (InvalidPathException e) {
                        throw new CommandException(
                                ExitCode.USAGE, "parameter '" + parameter.name() + "': " + e.getMessage(), e);
                    }
                }
            }
        }
        return folders;
    }

    /**
     * Checks that folders can be written to before hours are spent on their content; {@link ExitCode#USAGE} if a file would be
     * written twice, {@link ExitCode#OUTPUT} if one cannot be written.
     *
     * @param others all other files that will be written
     */
    static void check(List<SheetFolder> folders, List<Path> others) {
        List<Path> files = new ArrayList<>(others);
        for (SheetFolder folder : folders) {
            folder.check();
            if (Files.isDirectory(folder.folder)) {
                folder.files().forEach(file -> files.add(file.path()));
            }
        }
        OutputFile.checkWritable(files);
    }

    private void check() {
        Path place = folder.toAbsolutePath().normalize();
        if (Files.isDirectory(place)) {
            return;
        }
        Path parent = place.getParent();
        String problem = null;
        if (Files.exists(place)) {
            problem = "is not a directory";
        } else if (parent == null || !Files.isDirectory(parent)) {
            problem = "there is no directory " + parent;
        } else if (!Files.isWritable(parent)) {
            problem = "the directory " + parent + " is not writable";
        }
        if (problem != null) {
            throw new CommandException(ExitCode.OUTPUT, folder + ": cannot be written to: " + problem);
        }
    }

    /** The files that are written. */
    List<OutputFile> files() {
        return List.of(
                new OutputFile(folder.resolve(parameter + ".exr"), OutputFile.Format.EXR),
                new OutputFile(folder.resolve(parameter + ".png"), OutputFile.Format.PNG));
    }

    /**
     * Writes the images.
     *
     * @param image the film's image, the colour of the OpenEXR file
     * @param attributes what is said about it there
     * @param written receives each file that is complete
     * @throws ImageFileException if a file cannot be written
     */
    void write(ImageSheet sheet, FilmImage image, Map<String, ExrAttribute> attributes, List<OutputFile> written)
            throws ImageFileException {
        try {
            Files.createDirectories(folder);
        } catch (IOException e) {
            throw new ImageFileException(folder, "cannot be made: " + e.getMessage(), e);
        }
        Map<String, float[]> channels = new LinkedHashMap<>(image.channels());
        for (ImageSheet.Cell cell : sheet.cells()) {
            cell.image()
                    .channels()
                    .forEach((name, plane) -> channels.put(cell.block() + "." + cell.name() + "." + name, plane));
        }
        OutputFile layers = files().get(0);
        ExrWriter.write(layers.path(), OutputFile.exr(image.settings(), channels, attributes));
        written.add(layers);
        OutputFile page = files().get(1);
        ContactSheet.write(page.path(), sheet);
        written.add(page);
    }
}
