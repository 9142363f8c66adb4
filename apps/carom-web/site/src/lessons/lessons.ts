// Eight lessons for a lecture: each opens a file, asks a question, and knows from the engine's answer when it is answered.

import type { Doc, Reply } from "../engine/protocol";
import { impacts, scenes } from "../scenes";

export interface Lesson {
  id: string;
  title: string;
  /** What is seen. */
  about: string[];
  doc: Doc;
  /** What is to be done with the mouse. */
  question: string;
  /** Where to begin. */
  hint: string;
  /** How many different findings are wanted, and the finding of an answer: a question is answered when so many were found. */
  wanted: number;
  found: (reply: Reply) => string | undefined;
  /** What it shows, told when it is answered. */
  why: string[];
  source: string;
}

const example = (name: string): Doc => [...scenes, ...impacts].find((doc) => doc.name === name) ?? { name, text: "", files: {} };
const written = (name: string, text: string): Doc => ({ name, text, files: {} });

/** A uniform rod of 1 m and 1 kg whose end K strikes a floor. */
const rod = (name: string, law: string, velocity: string, spin: string, friction: number, restitution: number): Doc =>
  written(
    name,
    `# A uniform rod of 1 m strikes a floor with its end K.

law = "${law}"

[body]
mass     = "1 kg"
inertia  = "0.08333333333333333 kg m^2"
velocity = ${velocity}
spin     = "${spin}"

[[contact]]
name        = "K"
point       = ["348 mm", "-359 mm"]
normal      = [0, 1]
friction    = ${friction}
restitution = ${restitution}
`,
  );

const WEDGED = written(
  "lesson_wedge.toml",
  `# A rod leans between two walls. Its weight is all that acts.

gravity = "9.81 m/s^2"

[body]
mass     = "1 kg"
inertia  = "0.02 kg m^2"
velocity = ["0 m/s", "0 m/s"]

[[contact]]
name     = "A"
point    = ["-200 mm", "-60 mm"]
normal   = [1, 0]
friction = 0.2

[[contact]]
name     = "B"
point    = ["200 mm", "60 mm"]
normal   = [-1, 0]
friction = 0.2
`,
);

const BLOCK = written(
  "lesson_prism.toml",
  `# A homogeneous block, 100 mm wide, rocks on its two lower edges.

a_to_centre   = "50 mm"
centre_to_k   = "50 mm"
height        = "100 mm"        # of the mass centre: half of the block's own
inertia_ratio = 0.3333333333    # of any homogeneous block
roll_rate     = "1 rad/s"
tilt          = "5 deg"
strikes       = 8
`,
);

const type = (reply: Reply): string | undefined => /, type (\d)/.exec(reply.headline?.word ?? "")?.[1];

/** The energies that a law leaves. */
const energies = (reply: Reply, law: string): [number, number] | undefined =>
  reply.lab?.laws.find(({ name }) => name === law)?.energy ?? undefined;

export const LESSONS: Lesson[] = [
  {
    id: "routh",
    title: "Routh’s diagram",
    about: [
      "An impact takes no time. Its clock is the normal impulse: it grows from nothing until the bodies part.",
      "While the contact slips, friction is at its limit, and the impulse walks along an edge of the friction cone. Where the walk meets the line of sticking, the slip has stopped; where it meets the line of maximum compression, restitution begins.",
    ],
    doc: rod("lesson_routh.toml", "poisson", '["1 m/s", "-1 m/s"]', "0 rad/s", 0.3, 0.5),
    question: "Raise the friction until the slip stops before the greatest compression.",
    hint: "Move the slider of friction of contact K, and let the walk go on.",
    wanted: 1,
    found: (reply) => (reply.headline?.word.startsWith("C-sticking") === true ? "it sticks" : undefined),
    why: [
      "The walk is steeper now: it meets the line of sticking before the line of maximum compression. From there it follows the line of sticking, because the friction that sticking takes is within the cone.",
      "Restitution goes on to (1 + e) times the normal impulse of compression: that is Poisson’s law.",
    ],
    source: "E. J. Routh, Dynamics of a System of Rigid Bodies (1860)",
  },
  {
    id: "types",
    title: "Seven types of impact",
    about: [
      "With one contact there are seven ways for the walk to go: it slides throughout; its slip stops in compression or in restitution, and then sticks or turns round; or it had no slip to begin with.",
      "Which one it is follows from where the line of sticking and the line of maximum compression meet the cone.",
    ],
    doc: rod("lesson_types.toml", "poisson", '["1 m/s", "-1 m/s"]', "0 rad/s", 0.3, 0.5),
    question: "Find four different types.",
    hint: "Pull the arrow of the velocity and the contact K; change the friction and the spin.",
    wanted: 4,
    found: (reply) => type(reply),
    why: [
      "Three numbers decide: P_d, how much impulse it takes to stop the slip; P_q, how much there is until the greatest compression; and μ_s = W_tn/W_tt, the friction that holds the contact once it sticks.",
      "Where the friction is smaller than |μ_s|, a slip that stops turns round at once: the contact cannot be held.",
    ],
    source: "Y. Wang and M. T. Mason, J. Appl. Mech. 59 (1992) 635",
  },
  {
    id: "painleve",
    title: "Painlevé’s paradox",
    about: [
      "A rod leans, and its lower end slides on a rough plate, in the direction in which the rod leans. Under its weight no motion obeys all laws: every hypothesis breaks an inequality, and each says which.",
      "What follows is an impact without approach: friction alone drives the contact together.",
    ],
    doc: example("contact_painleve.toml"),
    question: "Lower the friction until the rod can slide again.",
    hint: "“Under forces” at the right lists the hypotheses. Try 1.4, 1.35, 1.34.",
    wanted: 1,
    found: (reply) => {
      const forces = reply.lab?.forces;
      return forces != null && forces.motions.length > 0 ? "a motion" : undefined;
    },
    why: [
      "A force N at the end changes its normal acceleration by (W_nn − μ W_tn) N. Here W_nn = 1.75/kg and W_tn = 1.299/kg, so from μ = 1.347 on a larger force presses the end further in: no force can hold it.",
      "Just below that friction the force that holds it is enormous: 1056 N at μ = 1.34, for a rod of 1 kg.",
    ],
    source: "P. Painlevé, C. R. Acad. Sci. 121 (1895) 112",
  },
  {
    id: "energy",
    title: "A law that creates energy",
    about: [
      "Newton’s law sets the velocity of the contact after the impact, −e times that before. Poisson’s law sets its impulse, Stronge’s its work. Without friction all three agree.",
      "With friction they differ, and Newton’s may create energy.",
    ],
    doc: rod("lesson_energy.toml", "newton", '["-0.3 m/s", "-1 m/s"]', "-3 rad/s", 0.3, 0.3),
    question: "Raise restitution and friction until Newton’s law leaves more energy than there was before.",
    hint: "Watch the table of laws at the right: energy before stands in its title.",
    wanted: 1,
    found: (reply) => {
      const newton = energies(reply, "newton");
      return newton !== undefined && newton[1] > newton[0] ? "more energy" : undefined;
    },
    why: [
      "Nothing feeds the impact: a law that leaves more energy than it found is wrong there. Kane and Levinson showed it in 1985 on a double pendulum that strikes the ground.",
      "Stronge’s law gives back e² of the work of compression, and so never creates energy at one contact.",
    ],
    source: "T. R. Kane and D. A. Levinson, Dynamics (1985); W. J. Stronge, Proc. R. Soc. Lond. A 431 (1990) 169",
  },
  {
    id: "cradle",
    title: "Newton’s cradle",
    about: [
      "Three equal balls touch; the first comes in with 1 m/s. Momentum and energy are kept by many outcomes: rigid bodies leave open how the contacts share the impact.",
      "“Together” treats the contacts as one. “In sequence” strikes one after the other. “By stiffness” asks springs, whose ratio and exponent decide.",
    ],
    doc: example("impact_cradle.toml"),
    question: "Make the last ball leave with more than 0.999 m/s.",
    hint: "Move the stiffness of the contacts against each other, or choose another way to share. Go to the end of the walk to see the velocities.",
    wanted: 1,
    found: (reply) => ((reply.lab?.motion.at(-1)?.[2]?.[0] ?? 0) > 0.999 ? "the last ball" : undefined),
    why: [
      "The softer the second contact is beside the first, the later it is loaded: the first collision is over before the second begins, and the sequence of the textbook comes out.",
      "Equal balls of steel, springs of Hertz with exponent 3/2, leave 0.995 m/s to the last and move the other two a little.",
    ],
    source: "Y. Liu, Z. Zhao and B. Brogliato, Proc. R. Soc. A 464 (2008) 3193",
  },
  {
    id: "wedge",
    title: "Jam and wedge",
    about: [
      "A rod stands between two walls and may fall between them. Its weight is all that acts.",
      "With little friction it falls. With enough friction it can also hold itself: both are consistent, and no law says which follows.",
    ],
    doc: WEDGED,
    question: "Make it possible that the rod holds itself.",
    hint: "Raise the friction of both contacts, or pull the contacts to nearly one level.",
    wanted: 1,
    found: (reply) => (reply.lab?.forces?.motions.some(([motion]) => motion === "A sticks, B sticks") === true ? "it holds" : undefined),
    why: [
      "Both forces can lie along the line from one contact to the other where that line is within both friction cones: its slope, 60/200 = 0.3, must be below μ. Then the rod holds any load: it is wedged.",
      "How hard the walls press is open: the forces that are listed are one choice, and any larger ones balance too. A feeder’s part that bridges a gap like this stays there.",
    ],
    source: "Statics: two forces that balance lie on one line, within both friction cones",
  },
  {
    id: "rocking",
    title: "The rocking block",
    about: [
      "A block rocks on its two lower edges. At each strike the edge K comes down, the edge A lets go, and a share of the energy is lost, whatever the material, even where nothing slides or rebounds: the spin keeps 1 − (3/2) sin²α, where α is the angle from the diagonal to the vertical.",
    ],
    doc: BLOCK,
    question: "Lower the block until the first strike ends its rocking.",
    hint: "Move the slider of height: it is the height of the mass centre.",
    wanted: 1,
    found: (reply) => (reply.sections?.timeline.includes("sticks at A and K") === true ? "it stays" : undefined),
    why: [
      "Where sin²α reaches 2/3 nothing is left of the spin: from b/h = √2 on, here a height of 35.4 mm, both edges stay on the ground. Squat blocks do not rock.",
    ],
    source: "G. W. Housner, Bull. Seismol. Soc. Am. 53 (1963) 403",
  },
  {
    id: "turn",
    title: "Why a part turns over",
    about: [
      "A part slides down a plate, tips over its edge, falls and strikes a second plate. This strike decides: it raises the spin, or takes it away.",
      "Here the part comes to lie turned over.",
    ],
    doc: example("case_2.toml"),
    question: "Drag the lower plate until the part lies on the same side as at the start.",
    hint: "The middle ring of a plate moves it as a whole. Watch the badge on the plate.",
    wanted: 1,
    found: (reply) => (reply.headline?.word === "same side" ? "same side" : undefined),
    why: [
      "How long the part falls decides how far it has turned when it strikes, and on which side of its mass centre the striking point is. The impulse then turns it on, or back.",
      "A gravity-impact feeder is nothing but plates for which this strike comes out right, with tolerance: see “How surely”.",
    ],
    source: "Polukoshko, Kononova and Sokolova, on a gravity-impact part feeder: case 2",
  },
];

/** The file of a lesson, as it begins. */
export const begun = ({ id, doc }: Lesson): Doc => ({ ...doc, lesson: id });

/** The lesson of an address like `#lesson=routh`. */
export function lessonOf(address: string): Doc | undefined {
  const lesson = LESSONS.find(({ id }) => address === `#lesson=${id}`);
  return lesson === undefined ? undefined : begun(lesson);
}
