/* Impacts by structs, beside closed forms. */
#include "check.h"

/* A ball leaves with e times its speed, by each law. */
static void a_ball_leaves_with_e_times_its_speed(void) {
    const int laws[] = { CAROM_LAW_POISSON, CAROM_LAW_STRONGE, CAROM_LAW_NEWTON };
    const double restitutions[] = { 0.0, 0.25, 0.5, 1.0 };
    for (int law = 0; law < 3; law++) {
        for (int k = 0; k < 4; k++) {
            double e = restitutions[k];
            carom_contact floor = floor_below();
            floor.restitution = e;
            /* A normal of any length says the same. */
            floor.normal[1] = 7.0;
            carom_impact_problem ball = ball_on(&floor);
            ball.law = laws[law];
            carom_impact_result after;
            carom_contact_end end;
            CHECK(carom_impact(&ball, &after, &end, NULL, NULL) == CAROM_STATUS_OK, "a ball");
            CHECK(after.walked && after.outcome == CAROM_OUTCOME_UNIQUE, "it has one answer");
            CHECK((int)after.law == laws[law], "by the law that was asked for");
            CHECK_NEAR(after.velocity[1], 3.0 * e, "velocity after");
            CHECK_NEAR(after.velocity[0], 0.0, "it goes straight up");
            CHECK_NEAR(after.spin, 0.0, "it does not turn");
            CHECK_NEAR(end.normal_impulse, 2.0 * (1.0 + e) * 3.0, "m (1 + e) v");
            CHECK_NEAR(end.tangential_impulse, 0.0, "no friction");
            CHECK_NEAR(end.normal_velocity, 3.0 * e, "at the contact");
            CHECK_NEAR(after.energy_before, 9.0, "m v^2 / 2");
            CHECK_NEAR(after.energy_after, 9.0 * e * e, "e^2 of it is left");
            CHECK(end.state == (e > 0 ? CAROM_CONTACT_STATE_SEPARATES : CAROM_CONTACT_STATE_STICKS), "its end");
        }
    }
}

/* Routh: a contact without slip that sticks takes P_n = (1 + e) v / (W_nn - W_tn^2 / W_tt) and P_t = -W_tn P_n / W_tt.
 * Source: Routh, Dynamics of a System of Rigid Bodies, 1860. */
static void a_bar_sticks_as_routh_says(void) {
    const double mass = 1.5, inertia = 1.5 / 12.0, x = -0.3, y = -0.4, e = 0.5, speed = 2.0;
    const double w_tt = 1 / mass + y * y / inertia;
    const double w_tn = -x * y / inertia;
    const double w_nn = 1 / mass + x * x / inertia;
    const double normal = (1 + e) * speed / (w_nn - w_tn * w_tn / w_tt);
    const double tangential = -w_tn / w_tt * normal;
    /* It sticks where friction is at least |W_tn / W_tt|, 0.49 here. */
    carom_contact end = { { x, y }, { 0, 1 }, 0.6, e };
    carom_impact_problem bar = { { mass, inertia, { 0, -speed }, 0 }, &end, 1, CAROM_LAW_POISSON };
    carom_impact_result after;
    carom_contact_end contact;
    carom_end_states *states = NULL;
    CHECK(carom_impact(&bar, &after, &contact, &states, NULL) == CAROM_STATUS_OK, "a bar");
    CHECK_NEAR(contact.normal_impulse, normal, "normal impulse");
    CHECK_NEAR(contact.tangential_impulse, tangential, "tangential impulse");
    CHECK_NEAR(after.velocity[0], tangential / mass, "velocity x");
    CHECK_NEAR(after.velocity[1], -speed + normal / mass, "velocity y");
    CHECK_NEAR(after.spin, (x * normal - y * tangential) / inertia, "spin");

    // ANCHOR: states
    /* The end state says the same. */
    CHECK(after.end_state_count == 1, "one end state");
    carom_end_state state;
    carom_contact_end again;
    CHECK(carom_end_states_read(states, 0, &state, &again, 1, NULL) == CAROM_STATUS_OK, "it is read");
    CHECK(state.contact_count == 1, "of one contact");
    CHECK_NEAR(again.normal_impulse, normal, "its normal impulse");
    CHECK_NEAR(state.spin, after.spin, "its spin");
    CHECK_NEAR(state.energy_after, after.energy_after, "its energy");
    carom_end_states_free(states);
    // ANCHOR_END: states
}

/* A ball that slips throughout takes mu times the normal impulse, against its slip. */
static void a_fast_ball_slips_throughout(void) {
    carom_contact floor = floor_below();
    carom_impact_problem ball = ball_on(&floor);
    ball.body.velocity[0] = 100.0;
    carom_impact_result after;
    carom_contact_end end;
    CHECK(carom_impact(&ball, &after, &end, NULL, NULL) == CAROM_STATUS_OK, "a fast ball");
    CHECK_NEAR(end.tangential_impulse, -0.3 * 9.0, "mu m (1 + e) v");
    CHECK_NEAR(after.velocity[0], 100.0 - 0.3 * 9.0 / 2.0, "slower");
    CHECK_NEAR(after.spin, -0.3 * 9.0 / 0.4, "and turning clockwise");
}

/* A uniform rod falls flat about one end that rests, on a smooth floor: the ends take m w l / 6 and m w l / 3. */
static void a_rod_falls_flat(void) {
    carom_contact ends[2] = { { { -0.5, 0 }, { 0, 1 }, 0, 0 }, { { 0.5, 0 }, { 0, 1 }, 0, 0 } };
    carom_impact_problem rod = { { 1.0, 1.0 / 12.0, { 0, -3 }, -6 }, ends, 2, CAROM_LAW_POISSON };
    carom_impact_result after;
    carom_contact_end contacts[2];
    CHECK(carom_impact(&rod, &after, contacts, NULL, NULL) == CAROM_STATUS_OK, "a rod");
    CHECK_NEAR(contacts[0].normal_impulse, 1.0, "m w l / 6");
    CHECK_NEAR(contacts[1].normal_impulse, 2.0, "m w l / 3");
    CHECK_NEAR(after.energy_after, 0.0, "it stops");
}

/* A plate on more legs than are walked has an end state, and no walk. */
static void many_contacts_have_an_end_state_alone(void) {
    carom_contact legs[CAROM_MOST_WALKED + 1];
    carom_contact_end ends[CAROM_MOST_WALKED + 1];
    for (size_t i = 0; i <= CAROM_MOST_WALKED; i++) {
        carom_contact leg = { { (double)i - 3.0, -1 }, { 0, 1 }, 0.0, 0.0 };
        legs[i] = leg;
    }
    carom_impact_problem plate = { { 2, 9, { 0, -3 }, 0 }, legs, CAROM_MOST_WALKED + 1, CAROM_LAW_POISSON };
    carom_impact_result after;
    carom_end_states *states = NULL;
    CHECK(carom_impact(&plate, &after, ends, &states, NULL) == CAROM_STATUS_OK, "a plate");
    CHECK(!after.walked && after.outcome == CAROM_OUTCOME_FOUND, "one end state is found");
    CHECK(isnan(after.velocity[1]) && isnan(ends[0].normal_impulse), "no walk, no numbers");
    CHECK_NEAR(after.energy_before, 9.0, "what was before is known");
    carom_end_state state;
    CHECK(carom_end_states_read(states, 0, &state, ends, CAROM_MOST_WALKED + 1, NULL) == CAROM_STATUS_OK, "read");
    double sum = 0;
    for (size_t i = 0; i <= CAROM_MOST_WALKED; i++) {
        sum += ends[i].normal_impulse;
    }
    CHECK_NEAR(sum, 6.0, "together they stop it");
    CHECK_NEAR(state.velocity[1], 0.0, "it rests");
    carom_end_states_free(states);
}

int main(void) {
    a_ball_leaves_with_e_times_its_speed();
    a_bar_sticks_as_routh_says();
    a_fast_ball_slips_throughout();
    a_rod_falls_flat();
    many_contacts_have_an_end_state_alone();
    puts("impacts: 5 passed");
    return 0;
}
