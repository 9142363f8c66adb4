// The motion as a film: the picture is drawn frame by frame on a canvas, and the browser's own recorder writes it as WebM.

import { signal } from "@preact/signals";
import { playing } from "../bench/Picture";
import { save, stem } from "../download";
import { doc, notice, settled, shown } from "../state";

/** Frames a second, and the longest film [s]. */
const RATE = 25;
const LONGEST = 60;
/** The last picture stands so long [ms]. */
const HELD = 600;
/** Pixels of the film for one of the picture. */
const SHARP = 2;

/** How much of a film is there: from 0 to 1, undefined while none is made. */
export const filmed = signal<number | undefined>(undefined);
let wanted = false;

export const stopFilm = (): void => {
  wanted = false;
};

const styles = (): string =>
  [...document.styleSheets].flatMap((sheet) => [...sheet.cssRules].map((rule) => rule.cssText)).join("\n");

/** The picture as an image by itself: its styles come along, its rings do not. */
async function imageOf(picture: SVGSVGElement, css: string): Promise<HTMLImageElement> {
  const copy = picture.cloneNode(true) as SVGSVGElement;
  copy.querySelector(".grips")?.remove();
  copy.setAttribute("xmlns", "http://www.w3.org/2000/svg");
  const style = document.createElementNS("http://www.w3.org/2000/svg", "style");
  style.textContent = css;
  copy.prepend(style);
  const image = new Image();
  image.src = `data:image/svg+xml,${encodeURIComponent(new XMLSerializer().serializeToString(copy))}`;
  await image.decode();
  return image;
}

/** What the recorder is given: the canvas of a body in space itself, or one on which the picture is drawn. */
function stage(): Stage | undefined {
  const space = document.querySelector<HTMLCanvasElement>("#view-motion #solid");
  if (space !== null) return { canvas: space, draw: () => Promise.resolve() };
  const picture = document.querySelector<SVGSVGElement>("#view-motion svg.layout");
  if (picture === null) return undefined;
  const { width, height } = picture.viewBox.baseVal;
  const canvas = document.createElement("canvas");
  // An odd number of pixels is none for some coders.
  [canvas.width, canvas.height] = [2 * Math.round((SHARP * width) / 2), 2 * Math.round((SHARP * height) / 2)];
  const pen = canvas.getContext("2d");
  const css = styles();
  const paper = getComputedStyle(document.body).backgroundColor;
  return {
    canvas,
    draw: async () => {
      const image = await imageOf(picture, css);
      if (pen === null) return;
      pen.fillStyle = paper;
      pen.fillRect(0, 0, canvas.width, canvas.height);
      pen.drawImage(image, 0, 0, canvas.width, canvas.height);
    },
  };
}

/** Moves the motion to an instant: by the player of the plane, or by the slider of the one in space. */
function goTo(share: number, last: number): void {
  if (shown.peek().solid === undefined) {
    playing.peek()?.goTo(share * last);
    return;
  }
  const scrub = document.querySelector<HTMLInputElement>("#scrub");
  if (scrub === null) return;
  scrub.value = String(Math.round(1000 * share));
  scrub.dispatchEvent(new Event("input"));
}

/** The last instant of the motion [s]. */
function lastOf(): number {
  const { seen, solid } = shown.peek();
  const samples = (seen?.motion ?? (solid?.motion as { samples: unknown[] } | undefined))?.samples ?? [];
  const sample = samples.at(-1);
  return Array.isArray(sample) && typeof sample[0] === "number" ? sample[0] : 0;
}

interface Stage {
  canvas: HTMLCanvasElement;
  draw: () => Promise<void>;
}

/** Plays the motion frame by frame while the recorder runs; true where all that is wanted was played. */
async function played({ draw }: Stage, last: number, speed: number): Promise<boolean> {
  const of = doc.peek();
  const frames = Math.max(2, Math.ceil((RATE * last) / speed));
  const most = Math.min(frames, RATE * LONGEST);
  if (most < frames) notice.value = `The film ends after ${LONGEST} s: choose a higher speed for all of the motion.`;
  const began = performance.now();
  for (let frame = 0; frame <= most; frame += 1) {
    // Of another file it would be another motion.
    if (!wanted || doc.peek() !== of) return false;
    goTo(frame / frames, last);
    await draw();
    filmed.value = frame / most;
    // The recorder keeps the time of the clock on the wall.
    await new Promise((done) => setTimeout(done, Math.max(0, began + (1000 * (frame + 1)) / RATE - performance.now())));
  }
  // The end stands for a moment: of a short motion nothing would be recorded else.
  await draw();
  await new Promise((done) => setTimeout(done, HELD));
  return true;
}

/** Makes a film of the motion at the speed that is chosen, and saves it. */
export async function film(): Promise<void> {
  if (filmed.peek() !== undefined) return;
  await settled();
  const [on, last, { name }] = [stage(), lastOf(), doc.peek()];
  if (on === undefined || last <= 0 || typeof MediaRecorder === "undefined") {
    notice.value = "There is no motion to film here, or this browser has no recorder.";
    return;
  }
  const speed = Number(document.querySelector<HTMLSelectElement>("#speed")?.value ?? 1);
  [wanted, filmed.value] = [true, 0];
  try {
    const recorder = new MediaRecorder(on.canvas.captureStream(RATE), { mimeType: "video/webm", videoBitsPerSecond: 8e6 });
    const parts: Blob[] = [];
    recorder.ondataavailable = ({ data }) => parts.push(data);
    const over = new Promise<void>((done) => (recorder.onstop = () => done()));
    recorder.start();
    const whole = await played(on, last, speed);
    recorder.stop();
    await over;
    if (whole) save(`${stem(name)}.webm`, new Blob(parts, { type: "video/webm" }));
  } catch (error) {
    notice.value = `The film cannot be made: ${String(error)}`;
  }
  filmed.value = undefined;
}
