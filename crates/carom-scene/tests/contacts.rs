//! Contacts by the names of their materials stand for their ranges, and say where these are from.

use crate::held;

use carom_scene::quantity::Tolerance;
use carom_scene::{Form, NamedQuantity, ProblemKind, Problems, Scene};

fn read(contact: &str, plate: &str) -> Result<Scene, Problems> {
    let text = format!(
        "{contact}\n[part]\nshape = \"box\"\nlength = \"60 mm\"\nheight = \"12 mm\"\nmass = \"0.1 kg\"\n[start]\nto_edge = \"60 mm\"\n[[plate]]\nname = \"upper\"\nslope = \"35 deg\"\n{plate}\n[[plate]]\nname = \"lower\"\nslope = \"15 deg\"\nbelow = {{ x = \"30 mm\", y = \"-150 mm\" }}\n"
    );
    held::file(Form::Scene, &text);
    Scene::parse("scene.toml", &text)
}

fn quantity(scene: &Scene, path: &str) -> Option<NamedQuantity> {
    scene.quantities().into_iter().find(|quantity| quantity.path == path)
}

#[test]
fn a_name_counts_as_its_ranges_written_by_hand() {
    let named = read("contact = \"steel on steel, dry\"", "").unwrap();
    let hand =
        "contact = { friction = { low = 0.3, high = 0.6 }, restitution = { low = 0.45, high = 0.65 } }";
    let written = read(hand, "").unwrap();
    assert_eq!(named.feeder(), written.feeder(), "the middle is run");
    for path in ["contact.friction", "contact.restitution"] {
        let [a, b] = [&named, &written].map(|scene| quantity(scene, path).unwrap());
        assert_eq!((a.value, a.tolerance, a.written), (b.value, b.tolerance, b.written), "{path}");
    }
    let [a, b] = [&named, &written].map(|scene| scene.varied().unwrap());
    for share in [0.0, 0.3, 1.0] {
        let point = vec![share; 2];
        assert_eq!(a.feeder(&point).unwrap(), b.feeder(&point).unwrap(), "share {share}");
    }
}

#[test]
fn a_plate_may_be_of_another_material() {
    let scene = read("contact = \"steel on steel, dry\"", "contact = \"PTFE on steel, dry\"").unwrap();
    let friction = quantity(&scene, "plate.upper.friction").unwrap();
    assert_eq!(friction.tolerance, Some(Tolerance::Uniform { low: 0.04, high: 0.22 }), "its own range");
    assert!((scene.feeder().plates[0].friction - 0.13).abs() < f64::EPSILON, "its own middle");
    assert!((scene.feeder().plates[1].friction - 0.45).abs() < f64::EPSILON, "the contact's");
    let notes = scene.notes();
    assert!(
        notes.iter().any(|note| note.starts_with("contact: steel") && note.contains("OpenStax")),
        "{notes:?}"
    );
    assert!(notes.iter().any(|note| note.starts_with("plate.upper.contact: PTFE")), "{notes:?}");
}

/// Where every surface has its own, `contact` may be left out.
#[test]
fn a_contact_of_every_surface_needs_no_other() {
    let found = read("", "contact = \"PTFE on steel, dry\"").unwrap_err();
    assert_eq!(found.list[0].path, "contact.friction", "the lower plate has none: {found}");
    assert_eq!(found.list[0].kind, ProblemKind::MissingKey, "{found}");
}

#[test]
fn wrong_contacts_are_told_what_is_wrong() {
    let told = |contact: &str, plate: &str| {
        let found = read(contact, plate).unwrap_err();
        let lines = found.list.iter().map(|problem| format!("{}: {}", problem.path, problem.message));
        lines.collect::<Vec<_>>().join("\n")
    };
    let all = [
        told("contact = \"steel on steel\"", ""),
        told("contact = \"steel on teflon, dry\"", ""),
        told("contact = \"steel on aluminum, dry\"", ""),
        told("contact = 0.2", ""),
        told("contact = { friction = 0.2 }", "contact = \"brass on steel, dry\"\nfriction = 0.1"),
    ];
    insta::assert_snapshot!(all.join("\n"));
}
