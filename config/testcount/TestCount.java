import java.io.BufferedReader;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Ant task that makes the build end with the count of the tests that it ran, over all modules, as the line
 * {@code N passed, N failed, N skipped}.
 *
 * <p>Maven prints its own summary after the last plugin, so the line is printed when the JVM shuts down. It sums the
 * surefire reports written since this task ran; reports of an earlier build do not count. A build that runs no test prints
 * nothing. The class has no nested classes and no lambdas: Ant closes its loader before the hook runs.
 */
public final class TestCount extends SimpleFileVisitor<Path> implements Runnable {
    private static final Pattern SUITE = Pattern.compile("<testsuite\\s[^>]*");

    private final long startMillis = System.currentTimeMillis();
    private Path root = Path.of("").toAbsolutePath();
    private int tests;
    private int failed;
    private int skipped;

    /** Sets the folder that is searched for reports. Called by Ant. */
    public void setRoot(String folder) {
        root = Path.of(folder);
    }

    /** Registers the count for the end of the build. Called by Ant. */
    public void execute() {
        // Loads what the hook needs while the class loader is open.
        FileVisitResult.valueOf("CONTINUE");
        Runtime.getRuntime().addShutdownHook(new Thread(this, "test count"));
    }

    @Override
    public void run() {
        try {
            Files.walkFileTree(root, this);
        } catch (IOException e) {
            System.err.println("Cannot count the tests: " + e);
            return;
        }
        if (tests > 0) {
            PrintStream out = System.out;
            // Maven's last output is a colour reset without a newline.
            out.println();
            out.println((tests - failed - skipped) + " passed, " + failed + " failed, " + skipped + " skipped");
            out.flush();
        }
    }

    @Override
    public FileVisitResult preVisitDirectory(Path folder, BasicFileAttributes attributes) {
        String name = folder.getFileName().toString();
        boolean skip = name.startsWith(".") || name.equals("src") || name.equals("classes") || name.equals("test-classes");
        return skip && !folder.equals(root) ? FileVisitResult.SKIP_SUBTREE : FileVisitResult.CONTINUE;
    }

    @Override
    public FileVisitResult visitFile(Path file, BasicFileAttributes attributes) throws IOException {
        String name = file.getFileName().toString();
        boolean report = name.startsWith("TEST-") && name.endsWith(".xml")
                && file.getParent().getFileName().toString().equals("surefire-reports");
        if (report && attributes.lastModifiedTime().toMillis() >= startMillis) {
            add(file);
        }
        return FileVisitResult.CONTINUE;
    }

    private void add(Path report) throws IOException {
        StringBuilder head = new StringBuilder();
        try (BufferedReader reader = Files.newBufferedReader(report)) {
            String line = reader.readLine();
            while (line != null && !line.contains("<properties") && !line.contains("<testcase")) {
                head.append(line).append(' ');
                line = reader.readLine();
            }
        }
        Matcher suite = SUITE.matcher(head);
        if (suite.find()) {
            String attributes = suite.group();
            tests += number(attributes, "tests");
            failed += number(attributes, "failures") + number(attributes, "errors");
            skipped += number(attributes, "skipped");
        }
    }

    private static int number(String attributes, String name) {
        Matcher value = Pattern.compile("\\s" + name + "=\"(\\d+)\"").matcher(attributes);
        return value.find() ? Integer.parseInt(value.group(1)) : 0;
    }
}
