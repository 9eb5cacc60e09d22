package org.daybreak.core.scene;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;

/** A group of nodes with a common transform. May be the prototype of several {@link Instance}s. */
public final class Group extends Node {
    private final List<Node> children = new ArrayList<>();

    /** Appends a node. Returns it, so that it can be set up in one go. */
    public <T extends Node> T add(T node) {
        children.add(node);
        return node;
    }

    /** Removes a node if it is a child. */
    public void remove(Node node) {
        children.remove(node);
    }

    /** The children in order; a live, unmodifiable view. */
    public List<Node> children() {
        return Collections.unmodifiableList(children);
    }
}
