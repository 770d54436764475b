//! From a parsed TOML document to plain structs, with every problem found and placed.
//!
//! [`table!`] states the keys of a table once: name, type, range, default and documentation. From that one list come the
//! public struct, the reader that refuses any other key, and the JSON schema. Reading goes on after a problem, so that
//! one run shows them all; a value that could not be read is `None`, and its problem is in the [`Sink`].

mod macros;
mod plain;
mod schema;

pub(crate) use macros::{table, tagged, words};
pub(crate) use schema::{Definitions, Properties};

use crate::error::{MOST_PROBLEMS, Problem, Source, nearest};
use serde_json::{Value as Json, json};
use std::ops::Range;
use toml::de::{DeTable, DeValue};

/// Where a value is: a list from the value outwards, which becomes text only when there is a problem.
#[derive(Clone, Copy)]
pub(crate) enum At<'p> {
    Root,
    Key(&'p At<'p>, &'p str),
    Index(&'p At<'p>, usize),
}

impl At<'_> {
    pub(crate) fn path(&self) -> String {
        match self {
            At::Root => String::new(),
            At::Key(At::Root, key) => (*key).to_owned(),
            At::Key(outer, key) => format!("{}.{key}", outer.path()),
            At::Index(outer, index) => format!("{}[{index}]", outer.path()),
        }
    }
}

/// A value of the document with its place.
#[derive(Clone)]
pub(crate) struct Item<'v> {
    pub(crate) value: &'v DeValue<'v>,
    pub(crate) span: Range<usize>,
    pub(crate) at: At<'v>,
}

/// The problems found so far.
pub(crate) struct Sink<'s> {
    source: Source<'s>,
    pub(crate) problems: Vec<Problem>,
}

impl<'s> Sink<'s> {
    pub(crate) fn new(source: Source<'s>) -> Self {
        Self { source, problems: Vec::new() }
    }

    /// Notes a problem and returns `None`, the value that could not be read.
    pub(crate) fn refuse<T>(&mut self, item: &Item, message: impl Into<String>, help: Option<String>) -> Option<T> {
        self.note(item.span.clone(), item.at.path(), message.into(), help);
        None
    }

    pub(crate) fn note(&mut self, span: Range<usize>, path: String, message: String, help: Option<String>) {
        if self.problems.len() < MOST_PROBLEMS {
            self.problems.push(self.source.problem(span, path, message, help));
        }
    }
}

/// A type that a value of the document can become.
pub(crate) trait Decode: Sized {
    fn decode(item: &Item, out: &mut Sink) -> Option<Self>;
    /// What stands for a key that is not there; `None` if the key must be.
    fn missing() -> Option<Self> {
        None
    }
    fn schema(definitions: &mut Definitions) -> Json;
}

/// A type that is read from some of the keys of a table.
pub(crate) trait Keys: Sized {
    /// The name of the struct, and what a reader calls it: `Body`, `a body`.
    const NAME: (&'static str, &'static str);
    const ABOUT: &'static str;
    fn read(fields: &mut Fields) -> Option<Self>;
    fn properties(properties: &mut Properties, definitions: &mut Definitions);
}

impl<T: Keys> Decode for T {
    fn decode(item: &Item, out: &mut Sink) -> Option<Self> {
        let DeValue::Table(table) = item.value else {
            return mismatch(item, &format!("a table, {}", T::NAME.1), out);
        };
        let mut fields = Fields { table, item, noun: T::NAME.1.to_owned(), known: Vec::new(), lost: false, out };
        let value = T::read(&mut fields);
        fields.close();
        value
    }

    fn schema(definitions: &mut Definitions) -> Json {
        let name = T::NAME.0;
        if !definitions.contains_key(name) {
            // Entered before its properties are, so that a table that holds itself ends.
            definitions.insert(name.to_owned(), Json::Null);
            let mut properties = Properties::default();
            T::properties(&mut properties, definitions);
            definitions.insert(name.to_owned(), properties.into_schema(T::ABOUT));
        }
        json!({ "$ref": format!("#/$defs/{name}") })
    }
}

/// What every number under a key must satisfy, beyond being finite.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Rule {
    Any,
    Positive,
    NonNegative,
}

/// The keys of one table, as they are asked for.
pub(crate) struct Fields<'a, 'v, 's> {
    table: &'v DeTable<'v>,
    item: &'a Item<'v>,
    noun: String,
    known: Vec<&'static str>,
    /// Set when it is not known which keys belong here, so that none is called unknown.
    lost: bool,
    out: &'a mut Sink<'s>,
}

impl<'v> Fields<'_, 'v, '_> {
    fn find<'k>(&mut self, at: &'k At<'v>, key: &'static str) -> Option<Item<'k>>
    where
        'v: 'k,
    {
        self.known.push(key);
        let (_, value) = self.table.iter().find(|(name, _)| name.get_ref() == key)?;
        Some(Item { value: value.get_ref(), span: value.span(), at: At::Key(at, key) })
    }

    /// The value of `key`; what stands for it if it is not there.
    pub(crate) fn field<T: Decode>(
        &mut self,
        key: &'static str,
        about: &'static str,
        rule: Rule,
        default: Option<fn() -> T>,
    ) -> Option<T> {
        let at = self.item.at;
        let Some(item) = self.find(&at, key) else {
            return match default {
                Some(default) => Some(default()),
                None => T::missing().or_else(|| self.without(key, about)),
            };
        };
        let before = self.out.problems.len();
        let obeys = check_rule(&item, rule, self.out);
        let value = if obeys { T::decode(&item, self.out) } else { None };
        for problem in &mut self.out.problems[before..] {
            if problem.help.is_none() && problem.path == item.at.path() {
                problem.help = Some(format!("`{key}`: {}", about.trim()));
            }
        }
        value
    }

    fn without<T>(&mut self, key: &str, about: &str) -> Option<T> {
        let message = format!("missing key `{key}` in {}", self.noun);
        self.out.refuse(self.item, message, Some(format!("`{key}`: {}", about.trim())))
    }

    /// The value of `key`, one of `tags`, which decides what other keys there are.
    pub(crate) fn tag(&mut self, key: &'static str, tags: &[&'static str]) -> Option<&'static str> {
        self.lost = true;
        let at = self.item.at;
        let Some(item) = self.find(&at, key) else {
            let message = format!("missing key `{key}` in {}", self.noun);
            return self.out.refuse(self.item, message, Some(format!("one of {}", list(tags))));
        };
        let tag = choose(&item, tags, self.out)?;
        self.lost = false;
        self.noun = format!("{} of type `{tag}`", self.noun);
        Some(tag)
    }

    fn close(self) {
        if self.lost {
            return;
        }
        for (key, _) in self.table {
            let name = key.get_ref().as_ref();
            if !self.known.contains(&name) {
                let guess = nearest(name, self.known.iter().copied());
                let (guess, help) = match guess {
                    Some(guess) => (format!(", did you mean `{guess}`?"), None),
                    None => (String::new(), Some(format!("the keys are {}", list(&self.known)))),
                };
                let item = Item { value: &DeValue::Boolean(true), span: key.span(), at: At::Key(&self.item.at, name) };
                let name: String = name.chars().take(64).collect();
                self.out.refuse::<()>(&item, format!("unknown key `{name}` in {}{guess}", self.noun), help);
            }
        }
    }
}

/// Whether every number in the value satisfies the rule. What is not a number is left to the type to refuse.
fn check_rule(item: &Item, rule: Rule, out: &mut Sink) -> bool {
    match item.value {
        _ if rule == Rule::Any => true,
        DeValue::Array(items) => {
            let mut all = true;
            for (i, value) in items.iter().enumerate() {
                let item = Item { value: value.get_ref(), span: value.span(), at: At::Index(&item.at, i) };
                all &= check_rule(&item, rule, out);
            }
            all
        }
        DeValue::Integer(_) | DeValue::Float(_) => {
            let Some(number) = f64::decode(item, out) else { return false };
            let (holds, needed) = match rule {
                Rule::NonNegative => (number >= 0.0, "must not be negative"),
                Rule::Positive | Rule::Any => (number > 0.0, "must be positive"),
            };
            holds || out.refuse::<()>(item, format!("{needed}, found {number}"), None).is_some()
        }
        _ => true,
    }
}

/// Refuses a value of the wrong type.
pub(crate) fn mismatch<T>(item: &Item, wanted: &str, out: &mut Sink) -> Option<T> {
    let found = match item.value {
        DeValue::String(text) if text.chars().count() <= 40 => format!("the string {:?}", text.as_ref()),
        DeValue::String(_) => "a string".to_owned(),
        DeValue::Integer(number) => format!("the integer {}", number.to_string().chars().take(40).collect::<String>()),
        DeValue::Float(number) => format!("the number {}", number.as_str().chars().take(40).collect::<String>()),
        DeValue::Boolean(value) => value.to_string(),
        DeValue::Datetime(_) => "a date".to_owned(),
        DeValue::Array(items) => format!("an array of {}", items.len()),
        DeValue::Table(_) => "a table".to_owned(),
    };
    out.refuse(item, format!("expected {wanted}, found {found}"), None)
}

/// One of the words, or a problem that says which there are.
pub(crate) fn choose(item: &Item, words: &[&'static str], out: &mut Sink) -> Option<&'static str> {
    let DeValue::String(text) = item.value else { return mismatch(item, &format!("one of {}", list(words)), out) };
    if let Some(word) = words.iter().find(|word| **word == text.as_ref()) {
        return Some(word);
    }
    let (guess, help) = match nearest(text, words.iter().copied()) {
        Some(guess) => (format!(", did you mean \"{guess}\"?"), None),
        None => (String::new(), Some(format!("one of {}", list(words)))),
    };
    let text: String = text.chars().take(64).collect();
    out.refuse(item, format!("there is no {text:?} here{guess}"), help)
}

pub(crate) fn list(words: &[&str]) -> String {
    words.iter().map(|word| format!("`{word}`")).collect::<Vec<_>>().join(", ")
}
