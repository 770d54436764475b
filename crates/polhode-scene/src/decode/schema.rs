//! The JSON schema of a table, from the same list of keys that its reader comes from.

use super::{Decode, Keys, Rule};
use serde_json::{Map, Value as Json, json};

/// The tables that a schema refers to, by the name of their struct.
pub(crate) type Definitions = Map<String, Json>;

/// The properties of a table's schema.
#[derive(Default)]
pub(crate) struct Properties {
    own: Map<String, Json>,
    required: Vec<&'static str>,
    variants: Vec<(&'static str, &'static str, Properties)>,
}

impl Properties {
    pub(crate) fn add<T: Decode>(
        &mut self,
        key: &'static str,
        about: &str,
        rule: Rule,
        default: Option<Json>,
        definitions: &mut Definitions,
    ) {
        let mut schema = T::schema(definitions);
        restrict(&mut schema, rule);
        schema["description"] = about.trim().into();
        match default {
            Some(default) => schema["default"] = default,
            None if T::missing().is_none() => self.required.push(key),
            None => {}
        }
        self.own.insert(key.to_owned(), schema);
    }

    pub(crate) fn variant<T: Keys>(&mut self, tag: &'static str, definitions: &mut Definitions) {
        let mut properties = Self::default();
        T::properties(&mut properties, definitions);
        self.variants.push((tag, T::ABOUT, properties));
    }

    pub(super) fn into_schema(self, about: &str) -> Json {
        let object = |about: &str, properties: Map<String, Json>, required: Vec<&str>| {
            json!({ "type": "object", "description": about.trim(), "properties": properties, "required": required,
                    "additionalProperties": false })
        };
        if self.variants.is_empty() {
            return object(about, self.own, self.required);
        }
        let one_of: Vec<Json> = self
            .variants
            .into_iter()
            .map(|(tag, about, variant)| {
                let mut properties = self.own.clone();
                properties.insert("type".to_owned(), json!({ "const": tag }));
                properties.extend(variant.own);
                let required = ["type"].into_iter().chain(self.required.iter().copied()).chain(variant.required);
                object(about, properties, required.collect())
            })
            .collect();
        json!({ "description": about.trim(), "oneOf": one_of })
    }
}

fn restrict(schema: &mut Json, rule: Rule) {
    let Json::Object(entries) = schema else { return };
    if entries.get("type").is_some_and(|kind| kind == "number" || kind == "integer") {
        match rule {
            Rule::Any => {}
            Rule::Positive => drop(entries.insert("exclusiveMinimum".to_owned(), json!(0))),
            Rule::NonNegative => drop(entries.insert("minimum".to_owned(), json!(0))),
        }
    }
    for (_, inner) in entries.iter_mut() {
        match inner {
            Json::Array(items) => items.iter_mut().for_each(|item| restrict(item, rule)),
            inner => restrict(inner, rule),
        }
    }
}
