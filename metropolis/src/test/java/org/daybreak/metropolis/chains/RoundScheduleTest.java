package org.daybreak.metropolis.chains;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class RoundScheduleTest {
    @ParameterizedTest
    @CsvSource({
        "100000, 7, 0, 7",
        "100000, 7, 2, 5",
        "16, 16, 0, 16",
        "17, 16, 0, 16",
        "3, 1, 0, 1",
        "31, 10, 0, 4",
        "1000000, 3, 1, 2",
        "5, 5, 4, 5"
    })
    void dividesStepsEvenly(long total, int chains, int first, int end) {
        RoundSchedule schedule = new RoundSchedule(total, chains, first, end);
        long[] taken = new long[chains];
        long sum = 0;
        boolean newRound = true;
        int last = -1;
        while (!schedule.isDone()) {
            int chain = schedule.chain();
            assertTrue(chain >= first && chain < end);
            assertTrue(newRound ? chain == first : chain == last + 1);
            assertEquals(taken[chain], schedule.firstStep());
            int steps = schedule.stepsOfUnit();
            assertTrue(steps >= 1 && steps <= RoundSchedule.LONGEST);
            taken[chain] += steps;
            sum += steps;
            newRound = schedule.endsRound();
            last = chain;
            schedule.advance();
        }
        assertTrue(newRound);
        assertEquals(schedule.steps(), sum);
        for (int chain = first; chain < end; chain++) {
            assertEquals(schedule.share(chain), taken[chain]);
            assertTrue(Math.abs(taken[chain] - (double) total / chains) < 1);
        }
        if (end - first == chains) {
            assertEquals(total, sum);
        }
    }

    @Test
    void goesOnFromWhereItWas() {
        RoundSchedule schedule = new RoundSchedule(5003, 5, 0, 5);
        for (int i = 0; i < 23; i++) {
            schedule.advance();
        }
        StateWriter out = new StateWriter();
        schedule.save(out);
        RoundSchedule other = new RoundSchedule(5003, 5, 0, 5);
        other.restore(new StateReader(out.toArray()));
        while (!schedule.isDone()) {
            assertEquals(schedule.chain(), other.chain());
            assertEquals(schedule.firstStep(), other.firstStep());
            assertEquals(schedule.stepsOfUnit(), other.stepsOfUnit());
            schedule.advance();
            other.advance();
        }
        assertTrue(other.isDone());
    }

    @Test
    void mayBeWithoutEnd() {
        RoundSchedule schedule = new RoundSchedule(Long.MAX_VALUE, 3, 0, 3);
        assertEquals(Long.MAX_VALUE, schedule.steps());
        for (int i = 0; i < 1000; i++) {
            assertTrue(schedule.stepsOfUnit() > 0);
            schedule.advance();
        }
    }
}
