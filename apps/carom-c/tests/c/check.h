/* What the tests in C share: a check that says where and what, and numbers that agree to rounding. */
#ifndef CHECK_H
#define CHECK_H

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "carom.h"

/* Closed forms of a few operations agree with the engine to some units of the last of 53 binary digits. */
#define ROUNDING 1e-13

#define CHECK(holds, what)                                                     \
    do {                                                                       \
        if (!(holds)) {                                                        \
            fprintf(stderr, "%s:%d: %s: %s\n", __FILE__, __LINE__, what, #holds); \
            exit(1);                                                           \
        }                                                                      \
    } while (0)

#define CHECK_NEAR(found, expected, what)                                      \
    do {                                                                       \
        double found_ = (found), expected_ = (expected);                       \
        if (!(fabs(found_ - expected_) <= ROUNDING * (1.0 + fabs(expected_)))) { \
            fprintf(stderr, "%s:%d: %s: %.17g, expected %.17g\n", __FILE__, __LINE__, what, \
                    found_, expected_);                                        \
            exit(1);                                                           \
        }                                                                      \
    } while (0)

/* A ball of 2 kg and radius 1 m that strikes a floor with 3 m/s and e = 1/2. */
static inline carom_contact floor_below(void) {
    carom_contact floor = { { 0, -1 }, { 0, 1 }, 0.3, 0.5 };
    return floor;
}

static inline carom_impact_problem ball_on(const carom_contact *floor) {
    carom_impact_problem ball = { { 2.0, 0.4, { 0, -3 }, 0 }, floor, 1, CAROM_LAW_POISSON };
    return ball;
}

#endif
