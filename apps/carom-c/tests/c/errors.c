/* Everything that can be given wrongly: a status and a message, and nothing else is touched. */
#include "check.h"

#include <stdint.h>

/* Asks, and looks for words in the message. */
static void refused(const carom_impact_problem *problem, const char *words[], const char *what) {
    carom_impact_result after;
    memset(&after, 0x55, sizeof after);
    carom_impact_result untouched = after;
    char *message = NULL;
    carom_end_states *states = (carom_end_states *)(void *)&after;
    CHECK(carom_impact(problem, &after, NULL, &states, &message) == CAROM_STATUS_BAD_INPUT, what);
    CHECK(memcmp(&after, &untouched, sizeof after) == 0, what);
    CHECK(states == NULL, what);
    CHECK(message != NULL && strncmp(message, "{\"line\":1,\"error\":{\"problems\":[{", 32) == 0, what);
    for (; *words != NULL; words++) {
        if (strstr(message, *words) == NULL) {
            fprintf(stderr, "%s: no %s in %s\n", what, *words, message);
            exit(1);
        }
    }
    carom_free(message);
    /* Who does not want the message does not get one. */
    CHECK(carom_impact(problem, &after, NULL, NULL, NULL) == CAROM_STATUS_BAD_INPUT, what);
}

#define REFUSED(problem, what, ...) refused(problem, (const char *[]){ __VA_ARGS__, NULL }, what)

static void numbers_of_the_body(void) {
    carom_contact floor = floor_below();
    const double bad[] = { NAN, INFINITY, -INFINITY };
    for (int k = 0; k < 3; k++) {
        carom_impact_problem ball = ball_on(&floor);
        ball.body.mass = bad[k];
        REFUSED(&ball, "mass", "\"body.mass\"");
        ball.body.inertia = ball.body.velocity[0] = ball.body.velocity[1] = ball.body.spin = bad[k];
        REFUSED(&ball, "all at once", "\"body.mass\"", "\"body.inertia\"", "\"body.velocity", "\"body.spin\"");
    }
    carom_impact_problem ball = ball_on(&floor);
    ball.body.mass = 0.0;
    ball.body.inertia = -1.0;
    REFUSED(&ball, "no mass", "\"body.mass\"", "\"body.inertia\"");
}

static void numbers_of_the_contacts(void) {
    carom_contact floors[2] = { floor_below(), floor_below() };
    carom_impact_problem ball = ball_on(floors);
    ball.contact_count = 2;
    floors[0].friction = -0.1;
    floors[1].restitution = 1.5;
    floors[1].point[0] = NAN;
    REFUSED(&ball, "two contacts", "friction\"", "restitution\"", "point");
    floors[0] = floors[1] = floor_below();
    floors[1].normal[1] = 0.0;
    REFUSED(&ball, "no direction", "normal\"");
    floors[1].normal[1] = INFINITY;
    REFUSED(&ball, "an infinite normal", "normal");
}

static void law_and_counts(void) {
    carom_contact floor = floor_below();
    const int laws[] = { 3, -1, 1000000 };
    for (int k = 0; k < 3; k++) {
        carom_impact_problem ball = ball_on(&floor);
        ball.law = laws[k];
        ball.body.mass = -1;
        REFUSED(&ball, "a law", "\"law\"", "\"body.mass\"");
    }
    carom_impact_problem ball = ball_on(&floor);
    ball.contact_count = 0;
    REFUSED(&ball, "no contact", "contact");
    ball.contact_count = CAROM_MOST_CONTACTS + 1;
    REFUSED(&ball, "more than are resolved", "contact_count");
    ball.contact_count = SIZE_MAX;
    REFUSED(&ball, "a negative count", "contact_count");
    ball = ball_on(NULL);
    REFUSED(&ball, "NULL contacts", "\"contacts\"", "is NULL");
    ball = ball_on((const carom_contact *)(const void *)((const char *)&floor + 1));
    REFUSED(&ball, "contacts out of line", "\"contacts\"", "aligned");
    REFUSED(NULL, "no problem", "\"problem\"", "is NULL");
}

static void nowhere_to_write(void) {
    carom_contact floor = floor_below();
    carom_impact_problem ball = ball_on(&floor);
    char *message = NULL;
    CHECK(carom_impact(&ball, NULL, NULL, NULL, &message) == CAROM_STATUS_BAD_INPUT, "no result");
    CHECK(strstr(message, "\"result\"") != NULL, "it is named");
    carom_free(message);
    carom_impact_result after;
    CHECK(carom_impact(&ball, &after, NULL, NULL, (char **)(void *)((char *)&message + 1)) == CAROM_STATUS_BAD_INPUT,
          "a message out of line");
    CHECK(carom_run("", NULL, NULL, NULL) == CAROM_STATUS_BAD_INPUT, "no place for a drop");
    CHECK(carom_impact_json("", NULL, NULL, NULL) == CAROM_STATUS_BAD_INPUT, "no place for an answer");
    CHECK(carom_run_json("", NULL, NULL, NULL) == CAROM_STATUS_BAD_INPUT, "no place for an answer");
    /* Nothing is nothing to give back. */
    carom_free(NULL);
    carom_end_states_free(NULL);
}

static void end_states_that_are_not_there(void) {
    carom_contact floor = floor_below();
    carom_impact_problem ball = ball_on(&floor);
    carom_impact_result after;
    carom_end_states *states = NULL;
    CHECK(carom_impact(&ball, &after, NULL, &states, NULL) == CAROM_STATUS_OK, "a ball");
    carom_end_state state;
    carom_contact_end end;
    char *message = NULL;
    CHECK(carom_end_states_read(states, after.end_state_count, &state, NULL, 0, &message) == CAROM_STATUS_BAD_INPUT,
          "one too far");
    CHECK(strstr(message, "\"index\"") != NULL, "it is named");
    carom_free(message);
    CHECK(carom_end_states_read(states, 0, &state, &end, 0, &message) == CAROM_STATUS_BAD_INPUT, "no room");
    CHECK(strstr(message, "\"room\"") != NULL, "it is named");
    carom_free(message);
    CHECK(carom_end_states_read(NULL, 0, &state, NULL, 0, NULL) == CAROM_STATUS_BAD_INPUT, "no end states");
    CHECK(carom_end_states_read(states, 0, NULL, NULL, 0, NULL) == CAROM_STATUS_BAD_INPUT, "no place");
    CHECK(carom_end_states_read(states, 0, &state, NULL, 0, &message) == CAROM_STATUS_OK, "without contacts");
    CHECK(message == NULL, "no message where all is well");
    carom_end_states_free(states);
}

/* Asks both functions that answer with text, and the drop. */
static void text_refused(const char *text, const char *name, const char *words, const char *what) {
    for (int k = 0; k < 3; k++) {
        char *answer = (char *)(void *)&answer, *message = NULL;
        carom_drop_result drop;
        carom_status status = k == 0 ? carom_impact_json(text, name, &answer, &message)
                            : k == 1 ? carom_run_json(text, name, &answer, &message)
                                     : carom_run(text, name, &drop, &message);
        CHECK(status == CAROM_STATUS_BAD_INPUT, what);
        CHECK(k == 2 || answer == NULL, what);
        CHECK(message != NULL && strstr(message, words) != NULL, what);
        carom_free(message);
    }
}

static void texts(void) {
    text_refused(NULL, NULL, "is NULL", "no text");
    text_refused("\xff\xfe", NULL, "UTF-8", "no UTF-8");
    text_refused("a = 1", "\xff", "\"name\"", "a name that is no UTF-8");
    text_refused("", NULL, "problems", "an empty file");
    text_refused("= 3", NULL, "\"syntax\"", "no TOML");
    text_refused("{\"law\": ", NULL, "\"syntax\"", "no JSON");
    text_refused("{\"law\": null}", NULL, "null", "a null");
    text_refused("mas = 2\n", NULL, "\"unknown_key\"", "a key that is unknown");
    /* A file of another kind is told by both: an impact that has problems, and no scene. */
    text_refused("[body]\nmass = -1\n", NULL, "\"problems\":[{", "a file with problems");
}

int main(void) {
    numbers_of_the_body();
    numbers_of_the_contacts();
    law_and_counts();
    nowhere_to_write();
    end_states_that_are_not_there();
    texts();
    puts("errors: 6 passed");
    return 0;
}
