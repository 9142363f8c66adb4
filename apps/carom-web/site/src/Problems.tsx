// What is wrong with the scene as a whole, and what else should be known.

import type { Failure } from "./engine/protocol";
import { broken, failure, notice, takeBack } from "./state";

export function Notice() {
  if (notice.value === "") return null;
  return (
    <p class="problems" role="alert">
      {notice}{" "}
      <button type="button" onClick={() => (notice.value = "")}>
        Close
      </button>
    </p>
  );
}

/** Every problem of what was tried, where it was tried; the path stays unsaid where it is the field's own. */
export function Wrong({ failure: wrong, id, own = "" }: { failure: Failure | undefined; id?: string; own?: string }) {
  if (wrong === undefined) return null;
  return (
    <ul class="wrong" id={id} role="alert">
      {wrong.problems.map(({ path, message, help }) => (
        <li key={path + message}>
          {path === own ? "" : `${path} `}
          {message}
          {help === null ? "" : ` (${help})`}
        </li>
      ))}
      {wrong.problems.length === 0 && <li>{wrong.message}</li>}
    </ul>
  );
}

/** What is wrong with a scene as a whole, each problem with its line. */
export function Problems() {
  const wrong = failure.value;
  if (wrong === undefined || (wrong.tried !== "" && wrong.tried !== "text")) return null;
  return (
    <div class="problems" role="alert">
      <p>{wrong.problems.length === 0 ? wrong.message : `${wrong.message}: the picture shows the scene before.`}</p>
      <ul>
        {wrong.problems.map((problem, number) => (
          <li key={`${problem.path}-${problem.message}`}>
            {wrong.lines[number] == null ? "" : `line ${wrong.lines[number]}: `}
            <b>{problem.path}</b> {problem.message}
            {problem.help === null ? "" : ` (${problem.help})`}
          </li>
        ))}
      </ul>
      {broken.value !== undefined && (
        <button type="button" id="take-back" onClick={takeBack}>
          Take the text back
        </button>
      )}
    </div>
  );
}
