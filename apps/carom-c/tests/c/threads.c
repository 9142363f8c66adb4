/* Threads that ask at once get the answers of one that asks alone, bit for bit. An argument says how often each asks: under valgrind one
 * thread runs at a time. */
#include <pthread.h>

#include "check.h"

#define THREADS 8
#define IMPACTS 200

static carom_impact_result alone[IMPACTS];
static carom_end_states *shared;
static int rounds = IMPACTS;

/* The k-th of many impacts of a bar. */
static carom_impact_result impact(int k) {
    carom_contact ends[2] = { { { -0.3, -0.4 }, { 0, 1 }, 0.1 + 0.003 * k, 0.5 }, { { 0.4, -0.4 }, { 0, 1 }, 0.2, 0.1 } };
    carom_impact_problem bar = { { 1, 0.1, { 0.01 * k, -1 }, 1.0 - 0.01 * k }, ends, 1 + (size_t)k % 2, k % 3 };
    carom_impact_result after;
    memset(&after, 0, sizeof after);
    CHECK(carom_impact(&bar, &after, NULL, NULL, NULL) == CAROM_STATUS_OK, "an impact");
    return after;
}

static void same(const carom_impact_result *a, const carom_impact_result *b) {
    CHECK(memcmp(a->velocity, b->velocity, sizeof a->velocity) == 0, "velocity");
    CHECK(memcmp(&a->spin, &b->spin, sizeof a->spin) == 0, "spin");
    CHECK(memcmp(&a->energy_after, &b->energy_after, sizeof a->energy_after) == 0, "energy");
    CHECK(a->outcome == b->outcome && a->end_state_count == b->end_state_count, "outcome");
}

static void *ask(void *first) {
    for (int k = 0; k < rounds; k++) {
        int which = (k + *(const int *)first) % IMPACTS;
        carom_impact_result after = impact(which);
        same(&after, &alone[which]);
        /* One of them in eight is wrong, and each thread gets its own message. */
        if (k % 8 == 0) {
            carom_contact floor = floor_below();
            carom_impact_problem ball = ball_on(&floor);
            ball.body.mass = -1.0 - which;
            char *message = NULL, expected[32];
            snprintf(expected, sizeof expected, "%d", -1 - which);
            CHECK(carom_impact(&ball, &after, NULL, NULL, &message) == CAROM_STATUS_BAD_INPUT, "refused");
            CHECK(strstr(message, expected) != NULL, "its own number");
            carom_free(message);
        }
        carom_end_state state;
        CHECK(carom_end_states_read(shared, 0, &state, NULL, 0, NULL) == CAROM_STATUS_OK, "read by all at once");
        CHECK_NEAR(state.velocity[1], 1.5, "what all of them read");
    }
    return NULL;
}

int main(int count, char **words) {
    if (count > 1) {
        rounds = atoi(words[1]);
        CHECK(rounds > 0 && rounds <= IMPACTS, "threads [ROUNDS]");
    }
    pthread_t threads[THREADS];
    int firsts[THREADS];
    for (int k = 0; k < IMPACTS; k++) {
        alone[k] = impact(k);
    }
    carom_contact floor = floor_below();
    carom_impact_problem ball = ball_on(&floor);
    carom_impact_result after;
    CHECK(carom_impact(&ball, &after, NULL, &shared, NULL) == CAROM_STATUS_OK, "a ball");
    for (int i = 0; i < THREADS; i++) {
        firsts[i] = i * IMPACTS / THREADS;
        CHECK(pthread_create(&threads[i], NULL, ask, &firsts[i]) == 0, "a thread");
    }
    for (int i = 0; i < THREADS; i++) {
        CHECK(pthread_join(threads[i], NULL) == 0, "its end");
    }
    carom_end_states_free(shared);
    puts("threads: passed");
    return 0;
}
