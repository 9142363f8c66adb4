//! Answers are data: a text in an answer is one of a list of words, or the name of something, or a sentence beside the data that it tells.

use carom_scene::schema;
use serde_json::Value;
use std::collections::BTreeSet;

/// Names that a file gives, or that are made of such names: of plates, contacts, bodies, quantities, files, corners and features; units of such quantities.
const NAMES: &[&str] = &[
    "LineProblem.key",
    "LineProblem.path",
    "LineProblem.value",
    "BodyAccelerationReport.name",
    "BodyReport.name",
    "ClosedFormReport.case",
    "ClosedFormReport.kept",
    "ColumnReport.name",
    "ColumnReport.unit",
    "ContactReport.feature",
    "ContactReport.plate",
    "DeliveredReport.plate",
    "DoingReport.plate",
    "EndContactReport.name",
    "ForceContactReport.name",
    "ForcedReport.contact",
    "ImpactEventReport.contact",
    "InequalityReport.contact",
    "Limit.quantity",
    "OpenShareReport.contact",
    "PlateReport.plate",
    "PoseEndReport.vertices",
    "PoseThrowReport.set",
    "RegionsAxisReport.key",
    "RegionsAxisReport.unit",
    "RegionsBoundaryReport.labels",
    "RegionsJunctionReport.labels",
    "RegionsLabelReport.label",
    "RegionsSettingReport.unit",
    "RegionsThresholdReport.above",
    "RegionsThresholdReport.below",
    "RestingReport.held",
    "RestingReport.vertices",
    "SavedFeedReport.file",
    "SensitivityReport.quantity",
    "SmallestIntervalReport.limited_by",
    "SpatialBodyReport.name",
    "SpatialContactReport.name",
    "SpatialEndStateReport.kept",
    "SpatialImpactContactReport.name",
    "SpatialRejectedReport.at",
    "SpatialRejectedReport.kept",
    "SpatialSeriesReport.kept",
    "SpatialStageReport.held",
    "SpatialStrikeReport.kept",
    "SpatialStrikeReport.struck",
    "StageEndReport.plates",
    "StageReport.plate",
    "ThrownBodyReport.file",
    "ThrownFaceReport.vertices",
    "ThrownVertexReport.name",
    "TouchReport.feature",
    "TouchReport.plate",
    "Wanted.plate",
    "WorstReport.file",
    "TransitionReport.plate",
    "YieldPlateReport.plate",
    "design.scene",
    "feed.scene",
    "map.plate",
    "map.scene",
    "regions.diagram",
    "run.scene",
    "sweep.folder",
    "sweep.plate",
    "sweep.scene",
    "yield.plate",
    "yield.scene",
];
/// Sentences for people. Each stands beside the data that it tells.
const SENTENCES: &[&str] = &[
    "Approximation.text",
    "ClosedFormReport.words",
    "DecidersReport.because",
    "EndStateReport.hypothesis",
    "ForceMotionReport.hypothesis",
    "ImpactAnswerReport.not_staged",
    "ImpactReport.note",
    "RegionsLabelReport.words",
    "RejectedReport.because",
    "RejectedReport.hypothesis",
    "RollStrikeReport.state",
    "RollStrikeReport.words",
    "SharingReport.because",
    "SpatialEndReport.words",
    "SpatialEndStateReport.hypothesis",
    "SpatialForkReport.followed",
    "SpatialForkReport.others",
    "SpatialHypothesisReport.because",
    "SpatialHypothesisReport.hypothesis",
    "SpatialImpactReport.not_staged",
    "SpatialKeptReport.hypothesis",
    "SpatialRejectedReport.because",
    "SpatialRejectedReport.hypothesis",
    "SpatialStrikeReport.state",
    "SpatialWalkStageReport.ended_by",
    "SpatialWalkStageReport.forced",
    "SpatialWalkStageReport.ways_on",
    "StageReport.ended_by",
    "WalkStageReport.ended_by",
    "run.notes",
    "yield.notes",
    "design.delivered",
    "run.margin_of",
];

/// Sentences without such data: titles, remarks, a closed form's formula, what a scene wants, why a feed was broken off, what a
/// refused value must be.
const TOLD: &[&str] = &[
    "LineProblem.allowed",
    "LineProblem.help",
    "LineProblem.message",
    "FeedReport.broken_off",
    "PoseReport.law",
    "RegionsClosedFormReport.curve",
    "feed.wanted",
    "regions.remarks",
    "regions.title",
    "yield.wanted",
];

/// The keys of texts that may be anything, as `Type.key`; `what` is the answer's own name.
fn free_texts(schema: &Value, owner: &str, key: &str, found: &mut BTreeSet<String>) {
    let Value::Object(map) = schema else {
        if let Value::Array(items) = schema {
            items.iter().for_each(|item| free_texts(item, owner, key, found));
        }
        return;
    };
    let text = match map.get("type") {
        Some(Value::String(one)) => one == "string",
        Some(Value::Array(several)) => several.iter().any(|one| one == "string"),
        _ => false,
    };
    if text && !["enum", "const", "pattern"].iter().any(|limit| map.contains_key(*limit)) {
        found.insert(format!("{owner}.{key}"));
    }
    for (word, inner) in map {
        match (word.as_str(), inner) {
            ("$defs", Value::Object(types)) => {
                types.iter().for_each(|(name, of)| free_texts(of, name, "", found));
            }
            ("properties", Value::Object(keys)) => {
                keys.iter().for_each(|(name, of)| free_texts(of, owner, name, found));
            }
            _ => free_texts(inner, owner, key, found),
        }
    }
}

#[test]
fn a_text_in_an_answer_is_a_word_of_a_list_a_name_or_a_sentence_beside_data() {
    let answers = [
        ("run", schema::run()),
        ("impact", schema::impact()),
        ("contact", schema::contact()),
        ("roll", schema::roll()),
        ("map", schema::map()),
        ("yield", schema::yields()),
        ("design", schema::design()),
        ("feed", schema::feed()),
        ("sweep", schema::sweep()),
        ("regions", schema::regions()),
        ("error", schema::of::<carom_scene::LineError>()),
    ];
    let mut found = BTreeSet::new();
    for (name, schema) in answers {
        free_texts(schema.as_value(), name, "", &mut found);
    }
    let known: BTreeSet<String> =
        NAMES.iter().chain(SENTENCES).chain(TOLD).map(|key| (*key).to_owned()).collect();
    let new: Vec<&String> = found.difference(&known).collect();
    assert!(
        new.is_empty(),
        "texts that may be anything: give them an enum, or say here what they are: {new:#?}"
    );
    let gone: Vec<&String> = known.difference(&found).collect();
    assert!(gone.is_empty(), "texts that are there no more, or have their words now: {gone:#?}");
}
