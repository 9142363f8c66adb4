// The page: a bar above, the quantities at the left, the picture in the middle, what is said of it at the right.

import { useEffect } from "preact/hooks";
import { Bar } from "./Bar";
import { Picture } from "./bench/Picture";
import { Quantities } from "./bench/Quantities";
import { Words } from "./bench/Words";
import { begin, open, redo, said, undo } from "./state";

function keys(event: KeyboardEvent): void {
  const command = event.ctrlKey || event.metaKey;
  const inText = event.target instanceof HTMLInputElement || event.target instanceof HTMLTextAreaElement;
  if (!command || inText) return;
  const key = event.key.toLowerCase();
  if (key === "z") {
    event.preventDefault();
    void (event.shiftKey ? redo() : undo());
  } else if (key === "y") {
    event.preventDefault();
    void redo();
  }
}

async function dropped(event: DragEvent): Promise<void> {
  event.preventDefault();
  const file = event.dataTransfer?.files[0];
  if (file !== undefined) await open({ name: file.name, text: await file.text(), files: {} });
}

export function Studio() {
  useEffect(() => {
    addEventListener("keydown", keys);
    const over = (event: DragEvent) => event.preventDefault();
    const drop = (event: DragEvent) => void dropped(event);
    addEventListener("dragover", over);
    addEventListener("drop", drop);
    void begin();
    return () => {
      removeEventListener("keydown", keys);
      removeEventListener("dragover", over);
      removeEventListener("drop", drop);
    };
  }, []);
  return (
    <div class="studio">
      <Bar />
      <Quantities />
      <main>
        <Picture />
      </main>
      <Words />
      <p class="unseen" role="status">
        {said}
      </p>
    </div>
  );
}
