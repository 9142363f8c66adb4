//! What a file of each kind looks like, for those who have none yet.

/// What an impact file looks like, for those who have none yet.
pub(crate) const IMPACT_HELP: &str = "\
A file to start from (lengths from the mass centre; more in docs/impact.md):

  law = \"poisson\"                    # or stronge, newton
  [body]
  mass     = \"0.3 kg\"
  inertia  = \"2.5e-4 kg m^2\"
  velocity = [\"0.5 m/s\", \"-1.8 m/s\"]
  spin     = \"7.6 rad/s\"
  [[contact]]                        # one for each contact
  point       = [\"26 mm\", \"-42 mm\"]
  normal      = [0, 1]               # out of the obstacle into the body
  friction    = 0.15
  restitution = 0.2

Up to six contacts: what happens in stages, and every end state. Up to 24: one end state, others not searched for.
With --out DIR a page, the answer as JSON and the walk as SVG go to DIR/<file>/.";

/// What a file of contacts under forces looks like.
pub(crate) const CONTACT_HELP: &str = "\
A file as for `carom impact`, with forces; nothing approaches (more in docs/contact.md):

  gravity = \"9.81 m/s^2\"            # downwards, or a list [gx, gy]
  [body]
  mass     = \"1 kg\"
  inertia  = \"0.3333 kg m^2\"
  velocity = [\"1 m/s\", 0]
  force    = [\"0 N\", \"0 N\"]         # at the mass centre, beside the weight
  torque   = \"0 N m\"
  [[contact]]
  point    = [\"0.5 m\", \"-0.8660254 m\"]
  normal   = [0, 1]
  friction = 1.6

With --out DIR the answer goes to DIR/<file>/contact.json.";

/// What a map is asked for with, for those who have seen none yet.
pub(crate) const MAP_HELP: &str = "\
For example, which friction and which slope of the lower plate turn the part over:

  carom map examples/designer.toml --x \"plate.lower.slope=5..40 deg:60\" --y contact.friction=0.05..0.5:45

Quantities go by path, as in the scene and in `carom run --limits`; a plate by its name or its number.
Boundaries between outcomes are located by bisection of whole runs, not drawn through the grid.";

/// What a search for the interval of a feed does, for those who have seen none yet.
pub(crate) const FEED_HELP: &str = "\
Parts are fed one after another, as [feed] in the scene says, or three of them, at every interval that may matter.
Each is followed until it has left the last plate or rests: a part that has landed is in the way of the next until it is gone.
Of solid parts one is followed alone, and its way says when the next would touch it: what parts do that touch is not followed.";

/// What a fit reads and finds, for those who have seen none yet.
pub(crate) const FIT_HELP: &str = "\
RUNS.csv names its columns in its first line; every other line tells of one drop, or of `drops` that were alike:

  plate.upper.slope,outcome,time,drops
  12 deg,turned,0.842 s,1
  12 deg,same side,,7

  outcome   how it ended on the plate: same side, turned, face 2, stays on it; or stuck, delivered, missed, escaped, on end, jammed
  face      number of the face on which it lies there
  time      from the start until it lies flat there, or until the run ends; scatter is its standard deviation
  drops     how many drops the line tells of [1]
  a path    of the scene, as in `carom run --limits`: how the quantity was set

Without --over every friction and restitution is fitted that the scene writes, from 0 to 1. What has a tolerance varies from drop to drop;
what is not known but the same in all drops is named by --over.";
