// The widget's side in a notebook: the studio's page in a frame, and the file between both.
//
// The kernel sends the page when a view asks for it, as a message: it is larger than what a saved notebook should keep.

/** The file that the widget has. */
const file = (model) => ({ name: model.get("name"), text: model.get("text"), files: model.get("files") });
const KEYS = ["name", "text", "files"];

function render({ model, el }) {
  const frame = document.createElement("iframe");
  // The page asks for nothing else: it knows by this name that a page around it gives the file.
  frame.name = "carom-host";
  frame.title = "Carom studio";
  frame.style.cssText = "display: block; width: 100%; border: 1px solid rgb(128 128 128 / 40%); border-radius: 6px;";
  const sized = () => (frame.style.height = `${model.get("height")}px`);
  sized();
  el.append(frame);

  let port;
  // What the page was told or said last: it is not told that again.
  let known = "";
  const told = () => {
    const now = file(model);
    if (JSON.stringify(now) === known) return;
    known = JSON.stringify(now);
    port?.postMessage(now);
  };
  // A frame that is moved within its page is loaded again, and is given the file again.
  const loaded = () => {
    if (frame.srcdoc === "") return;
    port?.close();
    const channel = new MessageChannel();
    port = channel.port1;
    known = "";
    port.onmessage = ({ data }) => {
      known = JSON.stringify(data);
      for (const key of KEYS) model.set(key, data[key]);
      model.save_changes();
    };
    frame.contentWindow.postMessage({ carom: "host" }, "*", [channel.port2]);
    told();
  };
  frame.addEventListener("load", loaded);

  const came = (message, buffers) => {
    if (message.carom !== "page" || frame.srcdoc !== "") return;
    frame.srcdoc = new TextDecoder().decode(buffers[0]);
  };
  model.on("msg:custom", came);
  // All three keys of a change come at once: one file is told.
  let waiting = false;
  const soon = () => {
    if (waiting) return;
    waiting = true;
    queueMicrotask(() => {
      waiting = false;
      told();
    });
  };
  KEYS.forEach((key) => model.on(`change:${key}`, soon));
  model.on("change:height", sized);
  model.send({ carom: "page" });
  return () => {
    model.off("msg:custom", came);
    model.off("change:height", sized);
    KEYS.forEach((key) => model.off(`change:${key}`, soon));
    frame.removeEventListener("load", loaded);
    port?.close();
  };
}

export default { render };
