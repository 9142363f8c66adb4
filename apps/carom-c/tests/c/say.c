/* What the library says of a file: say impact|run FILE prints the answer as `carom` prints it.
 * say drop FILE prints outcome, verdict, face, time and strikes. The exit code is the status. */
#include <inttypes.h>

#include "check.h"

static char *text_of(const char *path) {
    FILE *file = fopen(path, "rb");
    CHECK(file != NULL, path);
    size_t room = 1 << 16, length = 0, got;
    char *text = malloc(room + 1);
    CHECK(text != NULL, "memory");
    while ((got = fread(text + length, 1, room - length, file)) > 0) {
        length += got;
        if (length == room) {
            char *more = realloc(text, 2 * room + 1);
            CHECK(more != NULL, "memory");
            text = more;
            room *= 2;
        }
    }
    fclose(file);
    text[length] = '\0';
    return text;
}

int main(int count, char **words) {
    CHECK(count == 3, "say impact|run|drop FILE");
    char *text = text_of(words[2]), *answer = NULL, *message = NULL;
    carom_status status;
    if (strcmp(words[1], "drop") == 0) {
        // ANCHOR: drop
        carom_drop_result drop;
        status = carom_run(text, words[2], &drop, &message);
        if (status == CAROM_STATUS_OK) {
            printf("%d %d %d %.17g %" PRIu64 " %zu\n", (int)drop.outcome, (int)drop.verdict, drop.face,
                   drop.end_time, drop.strikes, drop.landings);
        }
        // ANCHOR_END: drop
    } else if (strcmp(words[1], "run") == 0) {
        // ANCHOR: text
        status = carom_run_json(text, words[2], &answer, &message);
        // ANCHOR_END: text
    } else {
        status = carom_impact_json(text, words[2], &answer, &message);
    }
    if (answer != NULL) {
        fputs(answer, stdout);
    }
    if (message != NULL) {
        fprintf(stderr, "%s\n", message);
    }
    carom_free(answer);
    carom_free(message);
    free(text);
    return (int)status;
}
