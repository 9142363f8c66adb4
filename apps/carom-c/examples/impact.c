/* A bar falls on its end, which sticks: what does it do, and is that the only answer? */
#include <stdio.h>

#include "carom.h"

int main(void) {
    // ANCHOR: ten
    carom_contact end = { .point = { -0.3, -0.4 }, .normal = { 0, 1 }, .friction = 0.6, .restitution = 0.5 };
    carom_impact_problem bar = {
        .body = { .mass = 1.0, .inertia = 1.0 / 12.0, .velocity = { 0, -1 }, .spin = 0 },
        .contacts = &end, .contact_count = 1, .law = CAROM_LAW_POISSON,
    };
    carom_impact_result after;
    char *message = NULL;
    if (carom_impact(&bar, &after, NULL, NULL, &message) == CAROM_STATUS_OK && after.walked) {
        printf("velocity %.4f %.4f m/s, spin %.4f rad/s\n", after.velocity[0], after.velocity[1], after.spin);
        printf("energy %.4f J, before %.4f J\n", after.energy_after, after.energy_before);
        printf("%s\n", after.outcome == CAROM_OUTCOME_UNIQUE ? "the only answer" : "not the only answer");
    }
    // ANCHOR_END: ten

    // ANCHOR: wrong
    /* What is wrong is told at once, all of it. */
    bar.body.mass = -1.0;
    end.restitution = 2.0;
    if (carom_impact(&bar, &after, NULL, NULL, &message) == CAROM_STATUS_BAD_INPUT) {
        printf("%s\n", message);
    }
    carom_free(message);
    // ANCHOR_END: wrong
    return 0;
}
