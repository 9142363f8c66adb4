// Long work: a button that begins it, in its place one that stops it, and how far it is.

import type { ComponentChildren } from "preact";

interface Props {
  /** Of the first button; the other is told apart by `-stop`. */
  id: string;
  label: string;
  running: boolean;
  disabled?: boolean;
  begin: () => void;
  stop: () => void;
  /** How far it is, in words. */
  children: ComponentChildren;
}

export function Work({ id, label, running, disabled = false, begin, stop, children }: Props) {
  return (
    <>
      {running ? (
        <button type="button" id={`${id}-stop`} onClick={stop}>
          Stop
        </button>
      ) : (
        <button type="button" id={id} disabled={disabled} onClick={begin}>
          {label}
        </button>
      )}
      <span role="status">{children}</span>
    </>
  );
}
