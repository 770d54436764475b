//! The lists of keys and words, each stated once.

/// The keys of a table, stated once: documentation, `key: Type`, then a rule after a comma and a default after `=`.
macro_rules! table {
    (
        $(#[doc = $about:literal])+
        $noun:literal $Name:ident $(derive $Derived:ident)? {
            $(flatten $(#[doc = $flat_doc:literal])+ $flat:ident: $Flat:ty;)*
            $($(#[doc = $doc:literal])+ $key:ident: $Type:ty $(, $rule:ident)? $(= $default:expr)?;)*
        }
    ) => {
        $(#[doc = $about])+
        #[derive(Clone, Debug, PartialEq, $($Derived)?)]
        #[allow(rustdoc::broken_intra_doc_links, reason = "[m] is a unit")]
        pub struct $Name {
            $($(#[doc = $flat_doc])+ pub $flat: $Flat,)*
            $($(#[doc = $doc])+ pub $key: $Type,)*
        }

        impl $crate::decode::Keys for $Name {
            const NAME: (&'static str, &'static str) = (stringify!($Name), $noun);
            const ABOUT: &'static str = concat!($($about),+);

            #[allow(unused_variables, reason = "a table may have no keys of its own")]
            fn read(fields: &mut $crate::decode::Fields) -> Option<Self> {
                $(let $flat = <$Flat as $crate::decode::Keys>::read(fields);)*
                $(let $key = fields.field::<$Type>(
                    stringify!($key),
                    concat!($($doc),+),
                    $crate::decode::table!(@rule $($rule)?),
                    $crate::decode::table!(@default $($default)?),
                );)*
                Some(Self { $($flat: $flat?,)* $($key: $key?,)* })
            }

            #[allow(unused_variables, reason = "a table may have no keys of its own")]
            fn properties(
                properties: &mut $crate::decode::Properties,
                definitions: &mut $crate::decode::Definitions,
            ) {
                $(<$Flat as $crate::decode::Keys>::properties(properties, definitions);)*
                $(properties.add::<$Type>(
                    stringify!($key),
                    concat!($($doc),+),
                    $crate::decode::table!(@rule $($rule)?),
                    $crate::decode::table!(@json $($default)?),
                    definitions,
                );)*
            }
        }
    };
    (@rule) => { $crate::decode::Rule::Any };
    (@rule positive) => { $crate::decode::Rule::Positive };
    (@rule nonnegative) => { $crate::decode::Rule::NonNegative };
    (@default) => { None };
    (@default $default:expr) => { Some(|| $default.into()) };
    (@json) => { None };
    (@json $default:expr) => { Some(::serde_json::json!($default)) };
}
pub(crate) use table;

/// Tables that the key `type` tells apart, as an enum of structs that [`table!`] made.
macro_rules! tagged {
    ($(#[doc = $about:literal])+ $noun:literal $Name:ident { $($tag:literal $Variant:ident,)+ }) => {
        $(#[doc = $about])+
        #[derive(Clone, Debug, PartialEq)]
        pub enum $Name {
            $(#[doc = concat!("`type = \"", $tag, "\"`.")] $Variant($Variant),)+
        }

        impl $Name {
            /// The value of `type`.
            pub fn tag(&self) -> &'static str {
                match self { $(Self::$Variant(_) => $tag,)+ }
            }
        }

        impl $crate::decode::Keys for $Name {
            const NAME: (&'static str, &'static str) = (stringify!($Name), $noun);
            const ABOUT: &'static str = concat!($($about),+);

            fn read(fields: &mut $crate::decode::Fields) -> Option<Self> {
                match fields.tag("type", &[$($tag),+])? {
                    $($tag => <$Variant as $crate::decode::Keys>::read(fields).map(Self::$Variant),)+
                    _ => None,
                }
            }

            fn properties(
                properties: &mut $crate::decode::Properties,
                definitions: &mut $crate::decode::Definitions,
            ) {
                $(properties.variant::<$Variant>($tag, definitions);)+
            }
        }
    };
}
pub(crate) use tagged;

/// An enum of words.
macro_rules! words {
    ($(#[doc = $about:literal])+ $Name:ident { $($(#[doc = $doc:literal])+ $word:literal $Variant:ident,)+ }) => {
        $(#[doc = $about])+
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
        #[allow(rustdoc::broken_intra_doc_links, reason = "[m] is a unit")]
        pub enum $Name { $($(#[doc = $doc])+ $Variant,)+ }

        impl $Name {
            /// All of them, in the order of the documentation.
            pub const ALL: &'static [Self] = &[$(Self::$Variant),+];

            /// The word in the file.
            pub fn word(self) -> &'static str {
                match self { $(Self::$Variant => $word,)+ }
            }
        }

        impl<'de> ::serde::Deserialize<'de> for $Name {
            fn deserialize<D: ::serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                let word = String::deserialize(deserializer)?;
                let found = Self::ALL.iter().find(|known| known.word() == word);
                found.copied().ok_or_else(|| ::serde::de::Error::unknown_variant(&word, &[$($word),+]))
            }
        }

        impl ::serde::Serialize for $Name {
            fn serialize<S: ::serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
                serializer.serialize_str(self.word())
            }
        }

        impl $crate::decode::Decode for $Name {
            fn decode(item: &$crate::decode::Item, out: &mut $crate::decode::Sink) -> Option<Self> {
                match $crate::decode::choose(item, &[$($word),+], out)? {
                    $($word => Some(Self::$Variant),)+
                    _ => None,
                }
            }
            fn schema(_: &mut $crate::decode::Definitions) -> ::serde_json::Value {
                ::serde_json::json!({ "oneOf": [
                    $({ "const": $word, "description": concat!($($doc),+).trim() }),+
                ] })
            }
        }
    };
}
pub(crate) use words;
