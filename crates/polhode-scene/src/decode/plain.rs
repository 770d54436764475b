//! Numbers, words, lists: the values that every format has.

use super::{At, Decode, Definitions, Item, Sink, mismatch};
use serde_json::{Value as Json, json};
use toml::de::DeValue;

impl Decode for f64 {
    fn decode(item: &Item, out: &mut Sink) -> Option<Self> {
        let number = match item.value {
            DeValue::Integer(integer) => i128::from_str_radix(integer.as_str(), integer.radix()).ok().map(|i| i as f64),
            DeValue::Float(float) => float.as_str().parse().ok(),
            DeValue::String(_) => {
                mismatch::<()>(item, "a number", out);
                if let Some(problem) = out.problems.last_mut() {
                    problem.message.push_str("; numbers are in SI units, written without the unit");
                }
                return None;
            }
            _ => return mismatch(item, "a number", out),
        };
        match number {
            Some(number) if number.is_finite() => Some(number),
            _ => mismatch(item, "a finite number", out),
        }
    }
    fn schema(_: &mut Definitions) -> Json {
        json!({ "type": "number" })
    }
}

impl Decode for u32 {
    fn decode(item: &Item, out: &mut Sink) -> Option<Self> {
        let DeValue::Integer(integer) = item.value else { return mismatch(item, "a whole number", out) };
        match u32::from_str_radix(integer.as_str(), integer.radix()) {
            Ok(number) => Some(number),
            Err(_) => mismatch(item, "a whole number from 0 to 4294967295", out),
        }
    }
    fn schema(_: &mut Definitions) -> Json {
        json!({ "type": "integer", "minimum": 0, "maximum": u32::MAX })
    }
}

impl Decode for bool {
    fn decode(item: &Item, out: &mut Sink) -> Option<Self> {
        item.value.as_bool().or_else(|| mismatch(item, "true or false", out))
    }
    fn schema(_: &mut Definitions) -> Json {
        json!({ "type": "boolean" })
    }
}

impl Decode for String {
    fn decode(item: &Item, out: &mut Sink) -> Option<Self> {
        item.value.as_str().map(str::to_owned).or_else(|| mismatch(item, "a string", out))
    }
    fn schema(_: &mut Definitions) -> Json {
        json!({ "type": "string" })
    }
}

impl<T: Decode> Decode for Option<T> {
    fn decode(item: &Item, out: &mut Sink) -> Option<Self> {
        T::decode(item, out).map(Some)
    }
    fn missing() -> Option<Self> {
        Some(None)
    }
    fn schema(definitions: &mut Definitions) -> Json {
        T::schema(definitions)
    }
}

impl<T: Decode> Decode for Vec<T> {
    fn decode(item: &Item, out: &mut Sink) -> Option<Self> {
        let DeValue::Array(items) = item.value else { return mismatch(item, "an array", out) };
        let mut all = Some(Self::new());
        for (i, value) in items.iter().enumerate() {
            let item = Item { value: value.get_ref(), span: value.span(), at: At::Index(&item.at, i) };
            match (T::decode(&item, out), &mut all) {
                (Some(value), Some(all)) => all.push(value),
                _ => all = None,
            }
        }
        all
    }
    fn missing() -> Option<Self> {
        Some(Self::new())
    }
    fn schema(definitions: &mut Definitions) -> Json {
        json!({ "type": "array", "items": T::schema(definitions) })
    }
}

impl<T: Decode + Copy, const N: usize> Decode for [T; N] {
    fn decode(item: &Item, out: &mut Sink) -> Option<Self> {
        match item.value {
            DeValue::Array(items) if items.len() == N => {
                Vec::<T>::decode(item, out).and_then(|values| values.try_into().ok())
            }
            _ => mismatch(item, &format!("an array of {N}"), out),
        }
    }
    fn schema(definitions: &mut Definitions) -> Json {
        json!({ "type": "array", "items": T::schema(definitions), "minItems": N, "maxItems": N })
    }
}
