package org.daybreak.cli;

import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Proxy;
import org.daybreak.core.render.CancellationToken;
import org.jspecify.annotations.Nullable;

/**
 * Turns the signals of Ctrl-C, {@code kill} and a closed terminal into the cancellation of the render that runs. The first
 * signal makes it stop and write its image, the second ends the process at once. While nothing is rendered there is
 * nothing to save, and the first signal ends the process.
 */
final class Interrupts {
    private static final int SIGNAL_CODES_START = 128;

    private final CancellationToken cancellation = new CancellationToken();
    private @Nullable Thread listening;
    private boolean saving;
    private int signal;

    /** Cancelled by the first signal while an image is at stake. */
    CancellationToken cancellation() {
        return cancellation;
    }

    /** From now on a signal does not end the process before the image is written. */
    void protectImage() {
        Thread thread = listening;
        while (thread != null && thread.isAlive()) {
            try {
                thread.join();
            } catch (InterruptedException e) {
                // Whoever interrupts this thread asks for the end of the render; the renderer looks at the flag.
                Thread.currentThread().interrupt();
                break;
            }
        }
        synchronized (this) {
            saving = true;
        }
    }

    /** Exit code of the signal that was received, or the given one if there was none. */
    synchronized int exitCode(int otherwise) {
        return signal == 0 ? otherwise : SIGNAL_CODES_START + signal;
    }

    /**
     * Takes over the signals of this process. Signals that the process was started to ignore stay ignored. Does nothing on
     * a Java runtime without the module jdk.unsupported: there a signal ends the process. Returns before it is done.
     */
    void listen() {
        // What reflection needs takes a tenth of a second to load, and the program has other things to do.
        Thread thread = new Thread(this::takeOver, "daybreak-signals");
        thread.setDaemon(true);
        thread.start();
        listening = thread;
    }

    private void takeOver() {
        // Through reflection, as the compiler warns of each use of sun.misc. A shutdown hook would do for the first
        // signal, but while hooks run the virtual machine swallows the second.
        try {
            Class<?> signalClass = Class.forName("sun.misc.Signal");
            Class<?> handlerClass = Class.forName("sun.misc.SignalHandler");
            Object handler = Proxy.newProxyInstance(
                    handlerClass.getClassLoader(), new Class<?>[] {handlerClass}, (proxy, method, arguments) -> {
                        if (method.getName().equals("handle")) {
                            receive((Integer) signalClass.getMethod("getNumber").invoke(arguments[0]));
                            return null;
                        }
                        return method.getName().equals("equals") ? proxy == arguments[0] : (Object) 0;
                    });
            for (String name : new String[] {"HUP", "INT", "TERM"}) {
                try {
                    Object named = signalClass.getConstructor(String.class).newInstance(name);
                    signalClass.getMethod("handle", signalClass, handlerClass).invoke(null, named, handler);
                } catch (InvocationTargetException e) {
                    if (!(e.getCause() instanceof IllegalArgumentException)) {
                        throw e;
                    }
                    // The system has no such signal, or the virtual machine keeps it for itself (-Xrs).
                }
            }
        } catch (ReflectiveOperationException e) {
            // Without the module the virtual machine's own handling stays: the process ends.
            return;
        }
    }

    private synchronized void receive(int number) {
        if (signal != 0 || !saving) {
            Runtime.getRuntime().halt(SIGNAL_CODES_START + number);
        }
        signal = number;
        cancellation.cancel();
    }
}
