"""Drake (package ``drake``), discrete, with the contact approximation TAMSI, stiff contacts that dissipate all they can, and steps of 0.01 ms. Of the
approximations and stiffnesses that were tried it is the nearest. It has no coefficient of restitution, so cases with one are refused; drops are not
asked."""

from __future__ import annotations

from importlib import import_module
from itertools import count
from typing import Any

from carom.referee.engines.question import Question, Refused, Twist, settled

STEP = 1e-5
RADIUS = 0.005
#: Stiffness [N/m] and Hunt and Crossley's dissipation [s/m].
STIFFNESS, DISSIPATION = 1e8, 1e3
MOST_STEPS, PATIENCE = 300, 20


def impact(question: Question) -> list[Twist]:
    """The bodies after an impact."""
    if any(contact.restitution > 0 for contact in question.contacts):
        raise Refused("it has no coefficient of restitution")
    plant, bodies, context, simulator = _built(question)

    def twists() -> list[Twist]:
        found = []
        for body in bodies:
            moving = plant.EvalBodySpatialVelocityInWorld(context, body)
            v, w = moving.translational(), moving.rotational()
            found.append(Twist((float(v[0]), float(v[1]), float(v[2])), (float(w[0]), float(w[1]), float(w[2]))))
        return found

    instants = (number * STEP for number in count(1))
    return settled(question, lambda: simulator.AdvanceTo(next(instants)), twists, MOST_STEPS, PATIENCE)


def drop(_world: dict[str, Any]) -> str:
    """Not asked."""
    raise Refused("drops have no setting here")


def _built(question: Question) -> tuple[Any, list[Any], Any, Any]:
    """The plant of an impact with its bodies, ready to be stepped."""
    plants: Any = import_module("pydrake.multibody.plant")
    trees: Any = import_module("pydrake.multibody.tree")
    geometry: Any = import_module("pydrake.geometry")
    math: Any = import_module("pydrake.math")
    framework: Any = import_module("pydrake.systems.framework")
    analysis: Any = import_module("pydrake.systems.analysis")
    builder = framework.DiagramBuilder()
    plant, scene = plants.AddMultibodyPlantSceneGraph(builder, STEP)
    plant.set_discrete_contact_approximation(plants.DiscreteContactApproximation.kTamsi)
    plant.mutable_gravity_field().set_gravity_vector([0, 0, 0])
    bodies = []
    for number, body in enumerate(question.bodies):
        inertia = trees.RotationalInertia(*body.inertia)
        bodies.append(plant.AddRigidBody(f"body {number}", trees.SpatialInertia.MakeFromCentralInertia(body.mass, [0, 0, 0], inertia)))
    pairs = []
    for number, contact in enumerate(question.contacts):
        properties = geometry.ProximityProperties()
        geometry.AddContactMaterial(DISSIPATION, STIFFNESS, plants.CoulombFriction(contact.friction, contact.friction), properties)

        def sphere(body: int, side: float, number: int = number, contact: Any = contact, properties: Any = properties) -> Any:
            centre = question.bodies[body].centre
            at = [contact.point[i] + side * RADIUS * contact.normal[i] - centre[i] for i in range(3)]
            return plant.RegisterCollisionGeometry(bodies[body], math.RigidTransform(at), geometry.Sphere(RADIUS), f"contact {number}", properties)

        first = sphere(contact.into, 1.0)
        if contact.out_of is not None:
            pairs.append((first, sphere(contact.out_of, -1.0)))
        else:
            place = geometry.HalfSpace.MakePose(contact.normal, contact.point)
            pairs.append((first, plant.RegisterCollisionGeometry(plant.world_body(), place, geometry.HalfSpace(), f"ground {number}", properties)))
    plant.Finalize()
    _only_these(scene, geometry, pairs)
    diagram = builder.Build()
    root = diagram.CreateDefaultContext()
    context = plant.GetMyMutableContextFromRoot(root)
    for body, given in zip(bodies, question.bodies, strict=True):
        place = [x - v * STEP for x, v in zip(given.centre, given.twist.velocity, strict=True)]
        plant.SetFreeBodyPose(context, body, math.RigidTransform(place))
        plant.SetFreeBodySpatialVelocity(context, body, _spatial(given.twist))
    simulator = analysis.Simulator(diagram, root)
    simulator.Initialize()
    return plant, bodies, context, simulator


def _spatial(twist: Twist) -> Any:
    """A spatial velocity."""
    spatial: Any = import_module("pydrake.multibody.math")
    return spatial.SpatialVelocity(list(twist.spin), list(twist.velocity))


def _only_these(scene: Any, geometry: Any, pairs: list[tuple[Any, Any]]) -> None:
    """Lets every contact meet its own obstacle alone."""
    every = [shape for pair in pairs for shape in pair]
    manager = scene.collision_filter_manager()
    for pair in pairs:
        for one in pair:
            others = [shape for shape in every if shape not in pair]
            if others:
                declared = geometry.CollisionFilterDeclaration()
                declared.ExcludeBetween(geometry.GeometrySet([one]), geometry.GeometrySet(others))
                manager.Apply(declared)
