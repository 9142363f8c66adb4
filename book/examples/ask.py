"""From which friction on does a disc that is thrown on a floor stick to it? One process of Carom answers forty questions."""

import json
import subprocess


class Carom:
    """`carom impact -`, for one: it answers a line of JSON with a line of JSON."""

    def __init__(self, *words):
        self.process = subprocess.Popen(
            ["carom", *words, "-"], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, encoding="utf-8"
        )

    def ask(self, question):
        print(json.dumps(question), file=self.process.stdin, flush=True)
        return json.loads(self.process.stdout.readline())

    def close(self):
        self.process.stdin.close()
        return self.process.wait()


def thrown(friction):
    """A disc of 1 kg and 100 mm falls with 1 m/s and slips with 1.5 m/s."""
    body = {"mass": "1 kg", "inertia": 0.005, "velocity": [1.5, -1]}
    contact = {"point": ["0 mm", "-100 mm"], "normal": [0, 1], "friction": friction, "restitution": 0.5}
    return {"body": body, "contact": [contact]}


# ANCHOR: ask
carom = Carom("impact")
low, high = 0.0, 1.0
for _ in range(40):
    friction = (low + high) / 2
    answer = carom.ask(thrown(friction))
    if abs(answer["staged"]["contacts"][0]["slip_m_s"]) < 1e-12:
        high = friction
    else:
        low = friction
print(f"it stops slipping from friction {high:.9f} on")

# A line with problems is answered as well, and the next one is not hurt.
for problem in carom.ask(thrown(-0.2))["error"]["problems"]:
    print(f"{problem['path']}: {problem['message']}")
print("slips no more:", carom.ask(thrown(0.5))["outcome"])
print("exit code", carom.close())
# ANCHOR_END: ask

# ANCHOR: poses
carom = Carom("roll", "cylinder", "--poses", "40 ms")
answer = carom.ask({"radius": "100 mm", "roll_rate": 10, "distance": "100 mm", "gamma": "40 deg"})
for pose in answer["poses"]:
    (x, _), spin = pose["position_m"], pose["spin_rad_s"]
    print(f"{pose['t_s']:.3f} s  x {x:+.4f} m  spin {spin:+.3f} rad/s  {pose.get('at', '')}".rstrip())
print("exit code", carom.close())
# ANCHOR_END: poses
