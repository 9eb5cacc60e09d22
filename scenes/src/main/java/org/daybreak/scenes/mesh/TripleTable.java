package org.daybreak.scenes.mesh;

import java.util.Arrays;

/** Numbers distinct triples of integers in the order in which they are first seen. */
final class TripleTable {
    private final IntList triples = new IntList();

    /** Open hash table from a triple to its number, -1 where empty; its size is a power of two. */
    private int[] table = filled(1 << 10);

    /** Number of distinct triples. */
    int size() {
        return triples.size() / 3;
    }

    /** A component, 0 to 2, of the triple with a number. */
    int get(int number, int component) {
        return triples.get(3 * number + component);
    }

    /** The number of a triple; the next one if it is new. */
    int number(int a, int b, int c) {
        int mask = table.length - 1;
        int slot = hash(a, b, c) & mask;
        while (table[slot] >= 0) {
            int i = 3 * table[slot];
            if (triples.get(i) == a && triples.get(i + 1) == b && triples.get(i + 2) == c) {
                return table[slot];
            }
            slot = (slot + 1) & mask;
        }
        int number = size();
        table[slot] = number;
        triples.add(a);
        triples.add(b);
        triples.add(c);
        if (2 * (number + 1) > table.length) {
            rehash();
        }
        return number;
    }

    private void rehash() {
        int[] larger = filled(2 * table.length);
        int mask = larger.length - 1;
        for (int number = 0; number < size(); number++) {
            int slot = hash(get(number, 0), get(number, 1), get(number, 2)) & mask;
            while (larger[slot] >= 0) {
                slot = (slot + 1) & mask;
            }
            larger[slot] = number;
        }
        table = larger;
    }

    private static int hash(int a, int b, int c) {
        int h = (a * 0x9e3779b1 + b) * 0x85ebca6b + c;
        h = (h ^ (h >>> 15)) * 0xc2b2ae35;
        return h ^ (h >>> 16);
    }

    private static int[] filled(int size) {
        int[] t = new int[size];
        Arrays.fill(t, -1);
        return t;
    }
}
