package org.daybreak.cli;

import java.util.ArrayList;
import java.util.List;
import org.daybreak.core.accel.Intersectors;
import picocli.CommandLine;

/** Names and versions of program and virtual machine. */
final class Version implements CommandLine.IVersionProvider {
    /** Name and version of this program, such as {@code Daybreak 1.0}. */
    static String software() {
        String version = Version.class.getPackage().getImplementationVersion();
        return "Daybreak " + (version == null ? "(development)" : version);
    }

    /** Name and version of the virtual machine. */
    static String java() {
        return System.getProperty("java.vendor.version", System.getProperty("java.vendor", "unknown vendor")) + ", "
                + System.getProperty("java.vm.name") + " " + Runtime.version();
    }

    @Override
    public String[] getVersion() {
        List<String> lines = new ArrayList<>();
        lines.add(software());
        lines.add("Java: " + java());
        Intersectors.Selection selection = Intersectors.select();
        lines.add("Intersector: " + selection.provider().id() + " ("
                + selection.provider().description() + ")");
        selection.rejected().forEach((id, reason) -> lines.add("  not " + id + ": " + reason));
        return lines.toArray(new String[0]);
    }
}
