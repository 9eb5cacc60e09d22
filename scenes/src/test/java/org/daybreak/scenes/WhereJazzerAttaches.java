package org.daybreak.scenes;

import com.code_intelligence.jazzer.agent.AgentInstaller;
import org.junit.jupiter.api.extension.ConditionEvaluationResult;
import org.junit.jupiter.api.extension.ExecutionCondition;
import org.junit.jupiter.api.extension.ExtensionContext;

/**
 * Skips fuzz tests where Jazzer cannot attach itself to the virtual machine, which it does even when it only runs the inputs
 * that are there.
 */
public final class WhereJazzerAttaches implements ExecutionCondition {
    /** Attaches once, without instrumentation, and remembers how it went. */
    private static final class Attachment {
        private static final ConditionEvaluationResult RESULT = attach();

        private static ConditionEvaluationResult attach() {
            try {
                AgentInstaller.install(false);
                return ConditionEvaluationResult.enabled("Jazzer is attached");
            } catch (IllegalStateException | LinkageError e) {
                return ConditionEvaluationResult.disabled("Jazzer cannot attach itself here: " + e);
            }
        }
    }

    @Override
    public ConditionEvaluationResult evaluateExecutionCondition(ExtensionContext context) {
        boolean searching = context.getConfigurationParameter("jazzer.hooks")
                .map(Boolean::parseBoolean)
                .orElse(true);
        return searching ? ConditionEvaluationResult.enabled("Jazzer instruments") : Attachment.RESULT;
    }
}
