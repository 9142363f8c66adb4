import "../../../../crates/carom-figure/src/figure.css";
import "../../../../crates/carom-figure/src/joint.css";
import "../../../../crates/carom-figure/src/report.css";
import "../../../../crates/carom-figure/src/impact.css";
import "../../../../crates/carom-figure/src/yield.css";
import "../../../../crates/carom-figure/src/regions.css";
import "../../../../crates/carom-figure/src/solid.css";
import "./studio.css";
import { render } from "preact";
import { Studio } from "./Studio";

const root = document.getElementById("studio");
if (root !== null) {
  root.replaceChildren();
  render(<Studio />, root);
}
