// carom.h - what rigid parts do when they touch: exact impacts, and drops of a part feeder.
//
// Units are SI. The world has x to the right and y up; angles and spins are counter-clockwise. A
// contact's normal points out of the obstacle into the body, its tangent is the normal turned a
// quarter clockwise: where a body approaches, its normal velocity is negative.
//
// Any number of threads may call at once: no function keeps a state. Whatever the library hands
// out, texts and end states, is the caller's, who gives it back to carom_free or
// carom_end_states_free.
//
// A call that finds Carom itself at fault ends with CAROM_STATUS_FAULT, and says where on stderr.
// Where memory runs out the process ends, as programs in Rust do.
//
// This file is made: CAROM_HEADER=write cargo test -p carom-c --test header

#ifndef CAROM_H
#define CAROM_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

// Most contacts that an impact may have.
#define CAROM_MOST_CONTACTS 24

// Up to so many contacts an impact is walked through compression and restitution, and every end
// state is found. Of more contacts one end state is found.
#define CAROM_MOST_WALKED 6

// How a call ended.
typedef enum {
  // It was done. Several answers, or none, are results: the answer says so.
  CAROM_STATUS_OK = 0,
  // What was given has problems; the message lists all of them.
  CAROM_STATUS_BAD_INPUT = 1,
  // What was given is good, but no answer could be computed; the message says why.
  CAROM_STATUS_UNDONE = 2,
  // A fault of Carom itself. Please report it, with the message.
  CAROM_STATUS_FAULT = 3,
} carom_status;

// Whether an impact has one answer.
typedef enum {
  // One end state is consistent, and the walk ends in it without a choice.
  CAROM_OUTCOME_UNIQUE = 0,
  // Several end states are consistent, or the walk had to choose.
  CAROM_OUTCOME_SEVERAL = 1,
  // The walk chose nothing, and ends in none of the end states: the end depends on the way
  // there.
  CAROM_OUTCOME_PATH_DEPENDENT = 2,
  // No end state is consistent.
  CAROM_OUTCOME_NONE = 3,
  // End states are consistent, but the walk that tells which of them is reached has no answer.
  CAROM_OUTCOME_UNRESOLVED = 4,
  // One answer was found; others were not searched for.
  CAROM_OUTCOME_FOUND = 5,
  // No end state was found; that there is none is not known.
  CAROM_OUTCOME_NOT_FOUND = 6,
} carom_outcome;

// How restitution is measured.
typedef enum {
  // Normal impulse of restitution = e times that of compression.
  CAROM_LAW_POISSON = 0,
  // Work of the normal impulse in restitution = e squared times its work in compression.
  CAROM_LAW_STRONGE = 1,
  // Normal velocity after = -e times that before. It can create energy where the slip stops or
  // reverses.
  CAROM_LAW_NEWTON = 2,
} carom_law;

// What a contact does at the end of an impact.
typedef enum {
  // It opens, or takes no impulse.
  CAROM_CONTACT_STATE_SEPARATES = 0,
  // Normal velocity and slip after are zero.
  CAROM_CONTACT_STATE_STICKS = 1,
  // Normal velocity after is zero, the slip is not.
  CAROM_CONTACT_STATE_SLIPS = 2,
} carom_contact_state;

// How a drop of a feeder ends.
typedef enum {
  // Flat on the last plate.
  CAROM_DROP_OUTCOME_LANDED = 0,
  // It left over the edge of the last plate.
  CAROM_DROP_OUTCOME_DELIVERED = 1,
  // Friction holds it.
  CAROM_DROP_OUTCOME_STUCK = 2,
  // It rests on an end.
  CAROM_DROP_OUTCOME_ON_END = 3,
  // It is wedged between obstacles, or no impact resolves its contacts.
  CAROM_DROP_OUTCOME_JAMMED = 4,
  // It fell past the last plate.
  CAROM_DROP_OUTCOME_MISSED = 5,
  // It touched the last plate and left it before it lay flat.
  CAROM_DROP_OUTCOME_ESCAPED = 6,
  // The budget of events or of time ran out, or it swings for ever.
  CAROM_DROP_OUTCOME_NEVER_FLAT = 7,
  // More contacts met at once than can be resolved.
  CAROM_DROP_OUTCOME_UNRESOLVED = 8,
  // Another part stood in its place. Only in a feed.
  CAROM_DROP_OUTCOME_BLOCKED = 9,
} carom_drop_outcome;

// Which face of the part is down at the end, against the start.
typedef enum {
  // It does not lie flat at the end, or it is a disc.
  CAROM_VERDICT_NONE = 0,
  // The same face.
  CAROM_VERDICT_SAME = 1,
  // The opposite face: the part was turned.
  CAROM_VERDICT_TURNED = 2,
  // Another face; `face` has its number.
  CAROM_VERDICT_FACE = 3,
} carom_verdict;

// The end states of an impact.
typedef struct carom_end_states carom_end_states;

// A free rigid body in the plane, before the impact.
typedef struct {
  // Mass [kg]; above 0.
  double mass;
  // Moment of inertia about the mass centre [kg m^2]; above 0.
  double inertia;
  // Velocity of the mass centre (x, y) [m/s].
  double velocity[2];
  // Spin, counter-clockwise [rad/s].
  double spin;
} carom_body;

// Where the body is touched.
typedef struct {
  // The point, from the mass centre (x, y) [m].
  double point[2];
  // Normal out of the obstacle into the body (x, y); of any length but 0.
  double normal[2];
  // Coulomb's coefficient of friction; 0 or more.
  double friction;
  // Coefficient of restitution; 0 to 1.
  double restitution;
} carom_contact;

// An impact of one body.
typedef struct {
  // The body before.
  carom_body body;
  // The contacts: an array of `contact_count`. It stays the caller's.
  const carom_contact *contacts;
  // How many contacts there are: 1 to `CAROM_MOST_CONTACTS`.
  size_t contact_count;
  // The law of restitution: a value of `carom_law`.
  int law;
} carom_impact_problem;

// What an impact does.
typedef struct {
  // Whether this is the only answer.
  carom_outcome outcome;
  // The law that was obeyed: Poisson's where several contacts close at once.
  carom_law law;
  // True where the impact was walked to an end. Where it is false the numbers below, but for the
  // energy before and the count, are NaN: read the end states.
  bool walked;
  // Velocity of the mass centre after (x, y) [m/s].
  double velocity[2];
  // Spin after, counter-clockwise [rad/s].
  double spin;
  // Kinetic energy before [J].
  double energy_before;
  // Kinetic energy after [J].
  double energy_after;
  // How many end states are consistent; of more than `CAROM_MOST_WALKED` contacts, 1 where one
  // was found, else 0.
  size_t end_state_count;
} carom_impact_result;

// One contact at the end of an impact. The tangent is the normal turned a quarter clockwise.
typedef struct {
  // What it does.
  carom_contact_state state;
  // Impulse on the body along the normal [N s].
  double normal_impulse;
  // Impulse on the body along the tangent [N s].
  double tangential_impulse;
  // Velocity of the point along the normal after [m/s].
  double normal_velocity;
  // Velocity of the point along the tangent after [m/s].
  double slip;
} carom_contact_end;

// One consistent end state.
typedef struct {
  // Velocity of the mass centre after (x, y) [m/s].
  double velocity[2];
  // Spin after, counter-clockwise [rad/s].
  double spin;
  // Kinetic energy after [J].
  double energy_after;
  // The smallest slack of its inequalities, divided by the sum of their terms' sizes; infinite
  // where nothing was decided.
  double margin;
  // True where many impulses give this motion; those of the answer are one choice.
  bool indeterminate;
  // True where restitution created energy.
  bool gained_energy;
  // How many contacts there are.
  size_t contact_count;
} carom_end_state;

// How a drop of a feeder ended.
typedef struct {
  // How it ended.
  carom_drop_outcome outcome;
  // Which face is down at the end.
  carom_verdict verdict;
  // Number of the face that is down at the end, from 0; -1 where the verdict is
  // `CAROM_VERDICT_NONE`.
  int face;
  // When it ended [s].
  double end_time;
  // How many strikes there were. Series of ever smaller ones are closed at their limit, and
  // count as far as they were followed.
  uint64_t strikes;
  // On how many plates the part came to lie flat on its way.
  size_t landings;
  // The smallest inequality that decided, divided by the sum of its terms' sizes; infinite where
  // nothing was decided.
  double margin;
} carom_drop_result;

#ifdef __cplusplus
extern "C" {
#endif // __cplusplus

// The version of the library: `0.1.0`. The text is the library's and is never freed.
const char *carom_version(void);

// Resolves one impact of a body in the plane, exactly as the command `carom impact` does.
//
// `result` gets what the impact does. `ends`, an array of `problem->contact_count`, gets each
// contact at its end; NULL where nobody asks. `end_states` gets every consistent end state, to be
// read by `carom_end_states_read` and given back by `carom_end_states_free`; NULL where nobody
// asks, which is quicker. `message` gets NULL, or where the status is not `CAROM_STATUS_OK` a JSON
// object with all problems, to be given back by `carom_free`; NULL where nobody asks.
//
// Returns `CAROM_STATUS_OK`, also where there are several answers or none;
// `CAROM_STATUS_BAD_INPUT` for a NULL problem, result or contacts, a count of contacts that is not
// 1 to `CAROM_MOST_CONTACTS`, a number that is not finite or out of its range, a normal of length
// 0, or an unknown law: then `result` and `ends` are as they were, and `end_states` gets NULL;
// `CAROM_STATUS_UNDONE` where the walk came to no end: then all are written, and `result->walked`
// is false.
//
// Memory: Every pointer is NULL or leads to as much as is said here, to write where it is not `const`, and
// nobody else writes there meanwhile.
carom_status carom_impact(const carom_impact_problem *problem,
                          carom_impact_result *result,
                          carom_contact_end *ends,
                          carom_end_states **end_states,
                          char **message);

// Reads one end state of an impact: `index` counts from 0 to below `result.end_state_count`.
//
// `state` gets its motion. `ends`, an array with room for `room` contacts, gets each contact; NULL
// where nobody asks. `message` is as that of `carom_impact`.
//
// Returns `CAROM_STATUS_OK`, or `CAROM_STATUS_BAD_INPUT` where a pointer is NULL that must not be,
// where there is no such end state, or too little room.
//
// Memory: `end_states` is NULL or of `carom_impact` and not freed; for the others as `carom_impact`.
// Several threads may read one at once.
carom_status carom_end_states_read(const carom_end_states *end_states,
                                   size_t index,
                                   carom_end_state *state,
                                   carom_contact_end *ends,
                                   size_t room,
                                   char **message);

// Gives back the end states of an impact. NULL is nothing to give back.
//
// Memory: `end_states` is NULL or of `carom_impact`, and is given back once.
void carom_end_states_free(carom_end_states *end_states);

// Resolves an impact file, in the plane or in space, of one body, of several, or of the operator
// alone.
//
// `file_text` is the text of the file, TOML or one JSON object, in UTF-8. `name` is the name of
// the file, under which its problems are reported; NULL for `impact.toml`. `answer` gets what
// `carom impact FILE --format json` prints, byte for byte, to be given back by `carom_free`.
// `message` is as that of `carom_impact`, in the form of the answers to lines of `carom impact -`
// (its `line` is 1).
//
// Returns `CAROM_STATUS_OK`; `CAROM_STATUS_BAD_INPUT` where the file has problems, a pointer is
// NULL that must not be, or a text is not UTF-8; `CAROM_STATUS_UNDONE` where the walk came to no
// end: then there is an answer, and a message as well.
//
// Memory: As `carom_impact`; texts end with a zero byte.
carom_status carom_impact_json(const char *file_text,
                               const char *name,
                               char **answer,
                               char **message);

// Drops the part of a scene, and feeds several where the scene asks for that.
//
// `scene_text` is the text of the scene, TOML or one JSON object, in UTF-8. `name` is the path of
// its file: its last part without `.toml` is the name of the scene, and a drawing that the scene
// names is read from beside it; NULL for `scene.toml` in the current folder. `answer` gets what
// `carom run SCENE --format json` prints, byte for byte, to be given back by `carom_free`. How far
// each quantity may move (`--limits`), pages and tables are the command's alone. `message` is as
// that of `carom_impact_json`.
//
// Returns `CAROM_STATUS_OK`, also where the part gets stuck or lost; `CAROM_STATUS_BAD_INPUT` as
// `carom_impact_json`; `CAROM_STATUS_UNDONE` where this feeder cannot be run.
//
// Memory: As `carom_impact_json`.
carom_status carom_run_json(const char *scene_text,
                            const char *name,
                            char **answer,
                            char **message);

// Drops the part of a scene, and says how that ends in numbers. A feed of several parts is not
// asked for.
//
// `scene_text` and `name` are as those of `carom_run_json`, `result` gets how the drop ends,
// `message` is as that of `carom_impact_json`.
//
// Returns what `carom_run_json` returns. Where it is not `CAROM_STATUS_OK`, `result` is as it was.
//
// Memory: As `carom_impact_json`.
carom_status carom_run(const char *scene_text,
                       const char *name,
                       carom_drop_result *result,
                       char **message);

// Gives back a text that the library handed out. NULL is nothing to give back.
//
// Memory: `text` is NULL or an `answer` or a `message` of this library, and is given back once, by this
// function and not by `free`.
void carom_free(char *text);

#ifdef __cplusplus
}  // extern "C"
#endif  // __cplusplus

#endif  /* CAROM_H */
