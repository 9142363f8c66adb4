//! The functions of `carom.h`: pointers in and out, and nothing else. What they do is in the other modules, without pointers.
#![allow(
    unsafe_code,
    reason = "C hands over pointers; this is the one file of the library that follows them"
)]

use crate::impact::{EndStates, Struck};
use crate::plain::{
    Contact, ContactEnd, DropResult, EndState, ImpactProblem, ImpactResult, MOST_CONTACTS, Status,
};
use crate::refusal::Refusal;
use crate::text::Answer;
use crate::{drop, text};
use carom_scene::ProblemKind;
use std::ffi::{CStr, CString, c_char};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::ptr;

const VERSION: &str = concat!(env!("CARGO_PKG_VERSION"), "\0");

/// The version of the library: `0.1.0`. The text is the library's and is never freed.
#[unsafe(no_mangle)]
pub extern "C" fn carom_version() -> *const c_char {
    VERSION.as_ptr().cast()
}

/// Resolves one impact of a body in the plane, exactly as the command `carom impact` does.
///
/// `result` gets what the impact does. `ends`, an array of `problem->contact_count`, gets each
/// contact at its end; NULL where nobody asks. `end_states` gets every consistent end state, to be
/// read by `carom_end_states_read` and given back by `carom_end_states_free`; NULL where nobody
/// asks, which is quicker. `message` gets NULL, or where the status is not `CAROM_STATUS_OK` a JSON
/// object with all problems, to be given back by `carom_free`; NULL where nobody asks.
///
/// Returns `CAROM_STATUS_OK`, also where there are several answers or none;
/// `CAROM_STATUS_BAD_INPUT` for a NULL problem, result or contacts, a count of contacts that is not
/// 1 to `CAROM_MOST_CONTACTS`, a number that is not finite or out of its range, a normal of length
/// 0, or an unknown law: then `result` and `ends` are as they were, and `end_states` gets NULL;
/// `CAROM_STATUS_UNDONE` where the walk came to no end: then all are written, and `result->walked`
/// is false.
///
/// # Safety
/// Every pointer is NULL or leads to as much as is said here, to write where it is not `const`, and
/// nobody else writes there meanwhile.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_impact(
    problem: *const ImpactProblem,
    result: *mut ImpactResult,
    ends: *mut ContactEnd,
    end_states: *mut *mut EndStates,
    message: *mut *mut c_char,
) -> Status {
    // SAFETY: the caller keeps what is said above; NULL and pointers out of line are refused before they are followed.
    unsafe {
        answered(message, || {
            clear("end_states", end_states)?;
            placed("result", result)?;
            aligned("ends", ends)?;
            let problem = read("problem", problem)?;
            let struck = Struck::of(problem, contacts(problem)?)?;
            result.write(struck.result());
            fill(ends, &struck.ends());
            if !end_states.is_null() {
                end_states.write(Box::into_raw(Box::new(struck.end_states())));
            }
            struck.undone().map_or(Ok(()), Err)
        })
    }
}

/// Reads one end state of an impact: `index` counts from 0 to below `result.end_state_count`.
///
/// `state` gets its motion. `ends`, an array with room for `room` contacts, gets each contact; NULL
/// where nobody asks. `message` is as that of `carom_impact`.
///
/// Returns `CAROM_STATUS_OK`, or `CAROM_STATUS_BAD_INPUT` where a pointer is NULL that must not be,
/// where there is no such end state, or too little room.
///
/// # Safety
/// `end_states` is NULL or of `carom_impact` and not freed; for the others as `carom_impact`.
/// Several threads may read one at once.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_end_states_read(
    end_states: *const EndStates,
    index: usize,
    state: *mut EndState,
    ends: *mut ContactEnd,
    room: usize,
    message: *mut *mut c_char,
) -> Status {
    // SAFETY: as `carom_impact`.
    unsafe {
        answered(message, || {
            placed("state", state)?;
            aligned("ends", ends)?;
            let all = read("end_states", end_states)?;
            let (found, contacts) = all.read(index).ok_or_else(|| {
                let said = format!("is {index}, and there are {} end states, counted from 0", all.count());
                Refusal::of_argument("index", ProblemKind::OutOfRange, said)
            })?;
            if !ends.is_null() && room < contacts.len() {
                let said = format!("is {room}, and there are {} contacts", contacts.len());
                return Err(Refusal::of_argument("room", ProblemKind::OutOfRange, said));
            }
            state.write(found);
            fill(ends, &contacts);
            Ok(())
        })
    }
}

/// Gives back the end states of an impact. NULL is nothing to give back.
///
/// # Safety
/// `end_states` is NULL or of `carom_impact`, and is given back once.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_end_states_free(end_states: *mut EndStates) {
    if !end_states.is_null() {
        // SAFETY: `carom_impact` made it of a box, and the caller gives it back once.
        std::mem::drop(unsafe { Box::from_raw(end_states) });
    }
}

/// Resolves an impact file, in the plane or in space, of one body, of several, or of the operator
/// alone.
///
/// `file_text` is the text of the file, TOML or one JSON object, in UTF-8. `name` is the name of
/// the file, under which its problems are reported; NULL for `impact.toml`. `answer` gets what
/// `carom impact FILE --format json` prints, byte for byte, to be given back by `carom_free`.
/// `message` is as that of `carom_impact`, in the form of the answers to lines of `carom impact -`
/// (its `line` is 1).
///
/// Returns `CAROM_STATUS_OK`; `CAROM_STATUS_BAD_INPUT` where the file has problems, a pointer is
/// NULL that must not be, or a text is not UTF-8; `CAROM_STATUS_UNDONE` where the walk came to no
/// end: then there is an answer, and a message as well.
///
/// # Safety
/// As `carom_impact`; texts end with a zero byte.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_impact_json(
    file_text: *const c_char,
    name: *const c_char,
    answer: *mut *mut c_char,
    message: *mut *mut c_char,
) -> Status {
    // SAFETY: as `carom_impact`.
    unsafe { told(("file_text", file_text), (name, "impact.toml"), (answer, message), text::impact) }
}

/// Drops the part of a scene, and feeds several where the scene asks for that.
///
/// `scene_text` is the text of the scene, TOML or one JSON object, in UTF-8. `name` is the path of
/// its file: its last part without `.toml` is the name of the scene, and a drawing that the scene
/// names is read from beside it; NULL for `scene.toml` in the current folder. `answer` gets what
/// `carom run SCENE --format json` prints, byte for byte, to be given back by `carom_free`. How far
/// each quantity may move (`--limits`), pages and tables are the command's alone. `message` is as
/// that of `carom_impact_json`.
///
/// Returns `CAROM_STATUS_OK`, also where the part gets stuck or lost; `CAROM_STATUS_BAD_INPUT` as
/// `carom_impact_json`; `CAROM_STATUS_UNDONE` where this feeder cannot be run.
///
/// # Safety
/// As `carom_impact_json`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_run_json(
    scene_text: *const c_char,
    name: *const c_char,
    answer: *mut *mut c_char,
    message: *mut *mut c_char,
) -> Status {
    // SAFETY: as `carom_impact`.
    unsafe { told(("scene_text", scene_text), (name, "scene.toml"), (answer, message), text::run) }
}

/// Drops the part of a scene, and says how that ends in numbers. A feed of several parts is not
/// asked for.
///
/// `scene_text` and `name` are as those of `carom_run_json`, `result` gets how the drop ends,
/// `message` is as that of `carom_impact_json`.
///
/// Returns what `carom_run_json` returns. Where it is not `CAROM_STATUS_OK`, `result` is as it was.
///
/// # Safety
/// As `carom_impact_json`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_run(
    scene_text: *const c_char,
    name: *const c_char,
    result: *mut DropResult,
    message: *mut *mut c_char,
) -> Status {
    // SAFETY: as `carom_impact`.
    unsafe {
        answered(message, || {
            placed("result", result)?;
            let (text, name) = (string("scene_text", scene_text)?, named(name, "scene.toml")?);
            result.write(drop::drop(name, text)?);
            Ok(())
        })
    }
}

/// Gives back a text that the library handed out. NULL is nothing to give back.
///
/// # Safety
/// `text` is NULL or an `answer` or a `message` of this library, and is given back once, by this
/// function and not by `free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_free(text: *mut c_char) {
    if !text.is_null() {
        // SAFETY: `given` made it of a `CString`, and the caller gives it back once.
        std::mem::drop(unsafe { CString::from_raw(text) });
    }
}

/// Does the work, whatever happens in it, and writes what is wrong into `message`.
///
/// # Safety
/// `message` is NULL or leads to a place to write.
unsafe fn answered(message: *mut *mut c_char, work: impl FnOnce() -> Result<(), Refusal>) -> Status {
    let whole = || {
        // SAFETY: the caller's word; a place out of line is refused first.
        let done = match unsafe { clear("message", message) } {
            Ok(()) => {
                catch_unwind(AssertUnwindSafe(work)).unwrap_or_else(|_| Err(Refusal::of_fault("it panicked")))
            }
            Err(_) => return Status::BadInput,
        };
        let Err(refusal) = done else { return Status::Ok };
        if !message.is_null() {
            // SAFETY: `clear` has written there.
            unsafe { message.write(given(refusal.json)) };
        }
        refusal.status
    };
    catch_unwind(AssertUnwindSafe(whole)).unwrap_or(Status::Fault)
}

/// Answers a text with a text.
///
/// # Safety
/// As [`carom_impact_json`].
unsafe fn told(
    (argument, file_text): (&str, *const c_char),
    (name, unnamed): (*const c_char, &'static str),
    (answer, message): (*mut *mut c_char, *mut *mut c_char),
    ask: fn(&str, &str) -> Result<Answer, Refusal>,
) -> Status {
    // SAFETY: the caller's word; NULL and pointers out of line are refused before they are followed.
    unsafe {
        answered(message, || {
            placed("answer", answer)?;
            clear("answer", answer)?;
            let Answer { json, undone } = ask(named(name, unnamed)?, string(argument, file_text)?)?;
            answer.write(given(json));
            undone.map_or(Ok(()), Err)
        })
    }
}

/// A text that the caller owns from here on. JSON writes a zero byte as an escape, so none is lost.
fn given(json: String) -> *mut c_char {
    CString::new(json).map_or(ptr::null_mut(), CString::into_raw)
}

/// Refuses a pointer of the wrong alignment, which nothing can be read from.
fn aligned<T>(name: &str, place: *const T) -> Result<(), Refusal> {
    if place.is_aligned() {
        return Ok(());
    }
    let said = format!("is not aligned: its address must be a multiple of {}", align_of::<T>());
    Err(Refusal::of_argument(name, ProblemKind::WrongValue, said))
}

/// Refuses NULL too.
fn placed<T>(name: &str, place: *const T) -> Result<(), Refusal> {
    if place.is_null() {
        return Err(Refusal::of_argument(name, ProblemKind::MissingKey, "is NULL"));
    }
    aligned(name, place)
}

/// Writes NULL where the caller wants a pointer.
///
/// # Safety
/// `place` is NULL or leads to a place to write.
unsafe fn clear<T>(name: &str, place: *mut *mut T) -> Result<(), Refusal> {
    aligned(name, place)?;
    if !place.is_null() {
        // SAFETY: the caller's word.
        unsafe { place.write(ptr::null_mut()) };
    }
    Ok(())
}

/// What a pointer leads to.
///
/// # Safety
/// `place` is NULL or leads to a T that lives as long as the call.
unsafe fn read<'a, T>(name: &str, place: *const T) -> Result<&'a T, Refusal> {
    placed(name, place)?;
    // SAFETY: the caller's word, and it is neither NULL nor out of line.
    Ok(unsafe { &*place })
}

/// The contacts of an impact.
///
/// # Safety
/// They are as many as it says.
unsafe fn contacts(problem: &ImpactProblem) -> Result<&[Contact], Refusal> {
    let ImpactProblem { contacts, contact_count, .. } = *problem;
    if contact_count == 0 {
        return Ok(&[]);
    }
    if contact_count > MOST_CONTACTS {
        let said = format!("is {contact_count}: at most {MOST_CONTACTS} contacts are resolved");
        return Err(Refusal::of_argument("contact_count", ProblemKind::OutOfRange, said));
    }
    placed("contacts", contacts)?;
    // SAFETY: the caller's word, and so many of them are no more memory than there is.
    Ok(unsafe { std::slice::from_raw_parts(contacts, contact_count) })
}

/// Writes the contacts where somebody asks for them.
///
/// # Safety
/// `place` is NULL or has room for all of them.
unsafe fn fill(place: *mut ContactEnd, ends: &[ContactEnd]) {
    if !place.is_null() {
        // SAFETY: the caller's word; what was just made does not overlap it.
        unsafe { ptr::copy_nonoverlapping(ends.as_ptr(), place, ends.len()) };
    }
}

/// A text.
///
/// # Safety
/// `place` is NULL or leads to a text that ends with a zero byte.
unsafe fn string<'a>(name: &str, place: *const c_char) -> Result<&'a str, Refusal> {
    placed(name, place)?;
    // SAFETY: the caller's word.
    unsafe { CStr::from_ptr(place) }.to_str().map_err(|error| {
        let said = format!("is not UTF-8: byte {} is none of it", error.valid_up_to());
        Refusal::of_argument(name, ProblemKind::Syntax, said)
    })
}

/// The name of a file, or the one that it has where none is given.
///
/// # Safety
/// As [`string`].
unsafe fn named<'a>(place: *const c_char, unnamed: &'static str) -> Result<&'a str, Refusal> {
    // SAFETY: the caller's word.
    if place.is_null() { Ok(unnamed) } else { unsafe { string("name", place) } }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_panic_ends_in_a_status_and_a_message() {
        let mut message = ptr::null_mut();
        // SAFETY: it is a place to write.
        let status = unsafe { answered(&raw mut message, || panic!("a test")) };
        assert_eq!(status, Status::Fault, "the status");
        // SAFETY: it was made by `given`.
        let said = unsafe { CString::from_raw(message) };
        assert!(said.to_str().unwrap().contains("a fault of Carom"), "{said:?}");
        // SAFETY: nobody asks for the message.
        let status = unsafe { answered(ptr::null_mut(), || panic!("a test")) };
        assert_eq!(status, Status::Fault, "without a message");
    }
}
