//! The interface in C: both libraries, and programs in C that are linked with each and tried.

use crate::examples::{is_example, program, verbs};
use crate::steps::{answers, build_for_tests, said_by};
use crate::{metadata, tree};
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

const CRATE: &str = "apps/carom-c";
/// What is compiled; the last one says what the library says of a file.
const PROGRAMS: [&str; 5] =
    ["examples/impact.c", "tests/c/impacts.c", "tests/c/errors.c", "tests/c/threads.c", "tests/c/say.c"];
const STRICT: [&str; 5] = ["-std=c11", "-Wall", "-Wextra", "-Werror", "-pedantic"];
/// What a static library of Rust needs of the system.
const SYSTEM: [&str; 3] = ["-lpthread", "-ldl", "-lm"];
const EXAMPLE: &str = "apps/carom-c/examples/impact.c";
const PAGE: &str = "apps/carom-c/README.md";
/// What the example prints, as the book shows it.
const SHOWN: &str = "apps/carom-c/examples/impact.txt";
/// Scenes that are dropped under valgrind too: each takes seconds there.
const WATCHED: [&str; 2] = ["examples/case_2.toml", "examples/bracket.toml"];

/// How often each thread asks there.
const ROUNDS: &str = "10";

/// A way to link.
struct Linked {
    name: &'static str,
    words: Vec<String>,
}

/// Builds, compiles, links and tries all of it, in the profile in which the tests are built.
pub(crate) fn check(root: &Path) -> Result<String, String> {
    build_for_tests(root)?;
    let target = metadata::workspace(root)?.target;
    let built = target.join("debug");
    let place = target.join("c");
    std::fs::create_dir_all(&place).map_err(|problem| format!("{}: {problem}", place.display()))?;
    let folder = built.to_string_lossy();
    let system = SYSTEM.map(str::to_owned);
    let ways = [
        Linked { name: "static", words: [vec![format!("{folder}/libcarom_c.a")], system.to_vec()].concat() },
        Linked {
            name: "dynamic",
            words: [
                vec![format!("-L{folder}"), "-lcarom_c".to_owned(), format!("-Wl,-rpath,{folder}")],
                system.to_vec(),
            ]
            .concat(),
        },
    ];
    let mut compared = 0;
    for way in &ways {
        let programs = PROGRAMS.map(|source| compile(root, &place, source, way));
        let [example, impacts, errors, threads, say] = programs;
        shown(root, &example?)?;
        for tests in [impacts?, errors?, threads?] {
            said_by(Command::new(tests))?;
        }
        compared += compare(root, &program(&target, "debug"), &say?)?;
    }
    let plus_plus = header_in_cpp(root, &place, &ways[0])?;
    let watched = watch(root, &place)?;
    Ok(format!("{compared} answers as the command's, statically and dynamically; {plus_plus}; {watched}"))
}

/// The compiler that the environment names, or the system's.
fn compiler(variable: &str, usual: &str) -> Command {
    Command::new(std::env::var(variable).unwrap_or_else(|_| usual.to_owned()))
}

fn made(place: &Path, source: &str, way: &Linked) -> PathBuf {
    let name = Path::new(source).file_stem().unwrap_or_default().to_string_lossy();
    place.join(format!("{name}-{}", way.name))
}

fn compile(root: &Path, place: &Path, source: &str, way: &Linked) -> Result<PathBuf, String> {
    let program = made(place, source, way);
    let mut command = compiler("CC", "cc");
    command.args(STRICT).arg(format!("-I{CRATE}/include")).arg(format!("{CRATE}/{source}"));
    command.arg("-o").arg(&program).args(&way.words).current_dir(root);
    said_by(command)?;
    Ok(program)
}

/// The example prints what the book shows, and its ten lines are those of the crate's page.
fn shown(root: &Path, example: &Path) -> Result<(), String> {
    let read = |path: &str| Ok::<_, String>(tree::text(root, path)?.unwrap_or_default());
    let (program, page) = (read(EXAMPLE)?, read(PAGE)?);
    let ten =
        program.split_once("// ANCHOR: ten\n").and_then(|(_, rest)| rest.split_once("    // ANCHOR_END"));
    let ten: String = ten
        .map_or("", |(ten, _)| ten)
        .lines()
        .map(|line| format!("{}\n", line.get(4..).unwrap_or_default()))
        .collect();
    if ten.is_empty() || !page.contains(&format!("```c\n{ten}```")) {
        return Err(format!("{PAGE} does not show the ten lines of {EXAMPLE}:\n{ten}"));
    }
    let said = said_by(Command::new(example))?;
    let expected = read(SHOWN)?;
    if said == expected { Ok(()) } else { Err(format!("{SHOWN} is not what the example prints:\n{said}")) }
}

/// Every example of the command that is an impact or a scene, asked of both: the same bytes.
fn compare(root: &Path, carom: &Path, say: &Path) -> Result<usize, String> {
    let mut compared = 0;
    for path in tree::files(root)?.iter().filter(|path| is_example(path)) {
        let text = tree::text(root, path)?.unwrap_or_default();
        let name = Path::new(path).file_stem().unwrap_or_default().to_string_lossy();
        let [verb @ ("impact" | "run")] = verbs(&name, &text)[..] else { continue };
        let out = root.join("target/c/out");
        let command = output(
            Command::new(carom).args([verb, path, "--format", "json", "--out"]).arg(&out).current_dir(root),
        )?;
        let library = output(Command::new(say).args([verb, path]).current_dir(root))?;
        if command.stdout != library.stdout || command.status.code() != library.status.code() {
            let told = String::from_utf8_lossy(&library.stderr).into_owned();
            return Err(format!("carom {verb} {path}: the library says something else\n{told}"));
        }
        compared += 1;
    }
    if compared == 0 { Err("there is no example to compare".to_owned()) } else { Ok(compared) }
}

fn output(command: &mut Command) -> Result<Output, String> {
    command.output().map_err(|problem| format!("{command:?}\n{problem}"))
}

/// The header as C++, where there is a compiler for it.
fn header_in_cpp(root: &Path, place: &Path, way: &Linked) -> Result<&'static str, String> {
    if !answers(compiler("CXX", "c++").arg("--version")) {
        return Ok("not tried as C++: there is no c++");
    }
    let source = "tests/c/header.cpp";
    let program = made(place, source, way);
    let mut command = compiler("CXX", "c++");
    command.args(["-std=c++17", "-Wall", "-Wextra", "-Werror", "-pedantic"]);
    command.arg(format!("-I{CRATE}/include")).arg(format!("{CRATE}/{source}"));
    command.arg("-o").arg(&program).args(&way.words).current_dir(root);
    said_by(command)?;
    said_by(Command::new(program))?;
    Ok("as C++ too")
}

/// Everything once more, in one of the two ways to link, where valgrind sees each access and each leak.
fn watch(root: &Path, place: &Path) -> Result<&'static str, String> {
    if !answers(Command::new("valgrind").arg("--version")) {
        return Ok("not watched: there is no valgrind");
    }
    let say = place.join("say-static");
    let mut runs: Vec<(PathBuf, Vec<&str>)> = ["impact", "impacts", "errors"]
        .iter()
        .map(|name| (place.join(format!("{name}-static")), vec![]))
        .collect();
    runs.extend(
        WATCHED.iter().flat_map(|path| [(say.clone(), vec!["run", path]), (say.clone(), vec!["drop", path])]),
    );
    runs.push((place.join("threads-static"), vec![ROUNDS]));
    runs.push((say, vec!["impact", "examples/impact_box.toml"]));
    for (program, words) in runs {
        let mut command = Command::new("valgrind");
        command.args(["--quiet", "--leak-check=full", "--error-exitcode=99"]).arg(program).args(words);
        command.current_dir(root);
        said_by(command)?;
    }
    Ok("no leak and no wrong access under valgrind")
}
