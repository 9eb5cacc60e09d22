package org.daybreak.architecture;

import static com.tngtech.archunit.core.domain.JavaModifier.STATIC;
import static com.tngtech.archunit.core.domain.JavaModifier.SYNTHETIC;
import static com.tngtech.archunit.lang.conditions.ArchPredicates.are;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.fields;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static com.tngtech.archunit.library.GeneralCodingRules.NO_CLASSES_SHOULD_ACCESS_STANDARD_STREAMS;
import static com.tngtech.archunit.library.GeneralCodingRules.NO_CLASSES_SHOULD_THROW_GENERIC_EXCEPTIONS;
import static com.tngtech.archunit.library.dependencies.SlicesRuleDefinition.slices;
import static org.junit.jupiter.api.Assertions.assertEquals;

import com.tngtech.archunit.base.DescribedPredicate;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.domain.JavaField;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.lang.ArchRule;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.PathMatcher;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

/** Checks the compiled classes of all modules and, for the documentation of packages, their sources. */
class ArchitectureTest {
    /** The repository. Its sub-folders are the modules. */
    private static final Path ROOT = Path.of(System.getProperty("daybreak.root"));

    private static final String BASE = "org.daybreak.";

    /** Top-level package below {@code org.daybreak} to the others that it may use. */
    private static final Map<String, Set<String>> ARROWS = Map.of(
            "exr", Set.of(),
            "core", Set.of(),
            "accel", Set.of("core"),
            "antialiasing", Set.of("core"),
            "tracing", Set.of("core", "antialiasing"),
            "bidirectional", Set.of("core", "tracing"),
            "metropolis", Set.of("core", "antialiasing", "tracing", "bidirectional"),
            "scenes", Set.of("core"),
            "cli", Set.of("exr", "core", "accel", "antialiasing", "tracing", "bidirectional", "metropolis", "scenes"),
            "benchmarks",
                    Set.of(
                            "exr",
                            "core",
                            "accel",
                            "antialiasing",
                            "tracing",
                            "bidirectional",
                            "metropolis",
                            "scenes",
                            "cli"));

    /** The programs: they may print, exit and use any library. All other top-level packages are library code. */
    private static final Set<String> PROGRAMS = Set.of("cli", "benchmarks");

    /** What every library module may use from outside. */
    private static final Set<String> COMMON = Set.of(
            "java..",
            "javax.imageio..",
            "javax.xml..",
            "org.w3c.dom..",
            "org.xml.sax..",
            "org.jspecify.annotations",
            "javax.vecmath");

    /** What single library modules may use besides. */
    private static final Map<String, Set<String>> EXTRA = Map.of(
            "accel", Set.of("jdk.incubator.vector"),
            "scenes", Set.of("com.fasterxml.jackson.core", "com.fasterxml.jackson.core.."));

    private static final Pattern NULL_MARKED =
            Pattern.compile("^@(org\\.jspecify\\.annotations\\.)?NullMarked$", Pattern.MULTILINE);

    private static JavaClasses all;
    private static JavaClasses libraries;

    @BeforeAll
    static void importClasses() throws IOException {
        List<Path> compiled;
        try (Stream<Path> folders = Files.list(ROOT)) {
            compiled = folders.map(folder -> folder.resolve("target").resolve("classes"))
                    .filter(Files::isDirectory)
                    .sorted()
                    .toList();
        }
        all = new ClassFileImporter().importPaths(compiled);
        libraries = all.that(DescribedPredicate.describe("library code", type -> !PROGRAMS.contains(module(type))));
    }

    @Test
    void everyTopLevelPackageHasItsArrows() {
        Set<String> unknown = new TreeSet<>();
        for (JavaClass type : all) {
            if (!ARROWS.containsKey(module(type))) {
                unknown.add(type.getPackageName());
            }
        }
        assertEquals(Set.of(), unknown, "packages of no known module: add them to ARROWS and to docs");
    }

    @Test
    void modulesUseOnlyWhatTheArrowsAllow() {
        for (String module : ARROWS.keySet()) {
            String own = BASE + module + "..";
            List<String> forbidden = new ArrayList<>();
            List<String> allowed = new ArrayList<>(COMMON);
            allowed.addAll(EXTRA.getOrDefault(module, Set.of()));
            allowed.add(own);
            for (String other : ARROWS.keySet()) {
                boolean mayUse = other.equals(module) || ARROWS.get(module).contains(other);
                (mayUse ? allowed : forbidden).add(BASE + other + "..");
            }
            check(noClasses()
                    .that()
                    .resideInAPackage(own)
                    .should()
                    .dependOnClassesThat()
                    .resideInAnyPackage(forbidden.toArray(String[]::new)));
            if (!PROGRAMS.contains(module)) {
                check(classes()
                        .that()
                        .resideInAPackage(own)
                        .should()
                        .onlyDependOnClassesThat()
                        .resideInAnyPackage(allowed.toArray(String[]::new)));
            }
        }
    }

    @Test
    void packagesFormNoCycle() {
        slices().matching(BASE + "(*)..")
                .should()
                .beFreeOfCycles()
                .allowEmptyShould(true)
                .check(all);
        slices().matching(BASE + "(**)")
                .should()
                .beFreeOfCycles()
                .allowEmptyShould(true)
                .check(all);
    }

    @Test
    void librariesNeitherPrintNorExit() {
        NO_CLASSES_SHOULD_ACCESS_STANDARD_STREAMS.allowEmptyShould(true).check(libraries);
        ArchRule exits = noClasses()
                .should()
                .callMethod(System.class, "exit", int.class)
                .orShould()
                .callMethod(Runtime.class, "exit", int.class)
                .orShould()
                .callMethod(Runtime.class, "halt", int.class);
        exits.allowEmptyShould(true).check(libraries);
    }

    /** A static field is a constant: final, and no holder of something that changes. */
    @Test
    void librariesHoldNoMutableStaticState() {
        DescribedPredicate<JavaField> written = DescribedPredicate.describe(
                "static fields of the source",
                field -> field.getModifiers().contains(STATIC)
                        && !field.getModifiers().contains(SYNTHETIC));
        DescribedPredicate<JavaClass> holder = DescribedPredicate.describe(
                "holders of changing values",
                type -> type.isAssignableTo(ThreadLocal.class)
                        || type.getPackageName().startsWith("java.util.concurrent")
                        || type.isAssignableTo(StringBuilder.class));
        fields().that(are(written))
                .should()
                .beFinal()
                .andShould()
                .notHaveRawType(holder)
                .allowEmptyShould(true)
                .check(libraries);
    }

    @Test
    void nothingThrowsGenericExceptions() {
        NO_CLASSES_SHOULD_THROW_GENERIC_EXCEPTIONS.allowEmptyShould(true).check(all);
    }

    /**
     * Packages of main sources describe themselves; those of tests, and of sources for later Java releases, share the
     * description of the main package of their name if there is one.
     */
    @Test
    void everyPackageIsDescribedAndNullMarked() throws IOException {
        Set<String> bare = new TreeSet<>();
        for (Path tree : sourceTrees()) {
            Path main = tree.resolveSibling(Path.of("..", "main", "java")).normalize();
            try (Stream<Path> files = Files.walk(tree)) {
                files.filter(file -> file.toString().endsWith(".java"))
                        .map(file -> tree.relativize(file).resolveSibling("package-info.java"))
                        .filter(info -> !isNullMarked(tree.resolve(info)) && !isNullMarked(main.resolve(info)))
                        .forEach(info -> bare.add(
                                ROOT.relativize(tree.resolve(info)).getParent().toString()));
            }
        }
        assertEquals(Set.of(), bare, "packages without a package-info.java that is @NullMarked");
    }

    private static boolean isNullMarked(Path description) {
        try {
            return Files.exists(description)
                    && NULL_MARKED.matcher(Files.readString(description)).find();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** The folders src/main/java, src/main/java25, src/test/java of all modules, and the tests at the top. */
    private static List<Path> sourceTrees() throws IOException {
        List<Path> trees = new ArrayList<>();
        for (String pattern : new String[] {"src/*/java*", "*/src/*/java*"}) {
            PathMatcher matcher = ROOT.getFileSystem().getPathMatcher("glob:" + pattern);
            try (Stream<Path> folders = Files.walk(ROOT, 4)) {
                folders.filter(Files::isDirectory)
                        .filter(folder -> matcher.matches(ROOT.relativize(folder)))
                        .forEach(trees::add);
            }
        }
        return trees;
    }

    private static void check(ArchRule rule) {
        rule.allowEmptyShould(true).check(all);
    }

    /** First package name below {@link #BASE}, or an empty string outside it. */
    private static String module(JavaClass type) {
        String name = type.getPackageName();
        if (!name.startsWith(BASE)) {
            return "";
        }
        int end = name.indexOf('.', BASE.length());
        return end < 0 ? name.substring(BASE.length()) : name.substring(BASE.length(), end);
    }
}
