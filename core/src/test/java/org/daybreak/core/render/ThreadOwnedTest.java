package org.daybreak.core.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertSame;

import java.lang.ref.WeakReference;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class ThreadOwnedTest {
    private final List<Object> retired = new ArrayList<>();

    @Test
    void isMadeByTheThreadThatUsesItAndAnewAfterACollection() throws InterruptedException {
        ThreadOwned<Object> owned = new ThreadOwned<>(Object::new, retired::add);
        Object first = owned.current();
        Object second = owned.renewed();
        assertNotSame(first, second, "the first is the caller's");
        collect();
        // Makers are quick here, but not infinitely so.
        Thread.sleep(100);
        Object third = owned.renewed();
        assertNotSame(second, third);
        assertSame(third, owned.current());
        assertEquals(List.of(first, second), retired);
    }

    @Test
    void isNotMadeAnewForTooLargeAPartOfTheTime() {
        int[] made = {0};
        ThreadOwned<Object> owned = new ThreadOwned<>(
                () -> {
                    made[0]++;
                    sleep(made[0] == 1 ? 0 : 50);
                    return new Object();
                },
                retired::add);
        owned.renewed();
        collect();
        owned.renewed();
        assertEquals(2, made[0], "50 ms are no more than 2 % of the time until 2.5 s have passed");
    }

    private static void collect() {
        WeakReference<Object> sentinel = new WeakReference<>(new Object());
        while (sentinel.get() != null) {
            System.gc();
        }
    }

    private static void sleep(int milliseconds) {
        try {
            Thread.sleep(milliseconds);
        } catch (InterruptedException e) {
            throw new IllegalStateException(e);
        }
    }
}
