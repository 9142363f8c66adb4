// The header is C++ as well.
#include "carom.h"

int main() {
    carom_contact floor = { { 0, -1 }, { 0, 1 }, 0.3, 0.5 };
    carom_impact_problem ball = { { 2.0, 0.4, { 0, -3 }, 0 }, &floor, 1, CAROM_LAW_POISSON };
    carom_impact_result after;
    carom_status status = carom_impact(&ball, &after, nullptr, nullptr, nullptr);
    return status == CAROM_STATUS_OK && after.walked && carom_version() != nullptr ? 0 : 1;
}
