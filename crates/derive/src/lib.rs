//! `#[derive(Say)]` and `message!`: the wording of an error, a warning or a remark is in the locale files and nowhere else.
//!
//! ```ignore
//! /// What is wrong with a table file.
//! #[derive(Debug, Clone, PartialEq, Eq, Say)]
//! #[say(prefix = "table", error)]
//! pub enum TableFault {
//!     /// Nothing but blanks and line ends.
//!     Empty,                                                    // table-empty
//!     /// A line beyond the bound of the reader.
//!     LineTooLong { limit: usize },                             // table-line-too-long = … { $limit } …
//!     /// A control character.
//!     NotText { #[say(with = code_point)] code: u32 },          // { $code } is code_point(&code)
//!     /// Beyond what a length can hold.
//!     #[say(args(most = Length::MAX))]
//!     TooFar(#[say(name = "given")] String),                    // { $given }, { $most }
//!     /// What another room says, as it says it.
//!     #[say(transparent)]
//!     Path(#[from] PathError),
//! }
//! ```
//!
//! The derive makes `Say` (the text's name with its values), `Display` (the English text), with `error` also
//! `std::error::Error`, and `From` for a field with `#[from]`.
//!
//! A text's name is the prefix and the variant's name in kebab case; `#[say(id = "…")]` on a variant, or on a struct,
//! gives another name. Arguments are the fields by name in kebab case; a single unnamed field is `$value` unless
//! `#[say(name = "…")]` names it, and `#[say(skip)]` leaves a field out. A field's type says with `IntoArg` how it is
//! put in. `args(…)` adds values that are computed from the fields, which are bound by reference.
//!
//! A text that `assets/locales/en` lacks, and an argument that the text asks for and the variant lacks, are compile
//! errors at the variant; the impls are still made, so that one mistake is one error. A test checks that the other
//! languages have the same texts.

mod input;
mod output;
mod texts;

use proc_macro::TokenStream;
use quote::quote;
use syn::{DeriveInput, LitStr, parse_macro_input};

/// The message of a name: `message!("table-empty")`. A name that `assets/locales/en` lacks does not compile.
#[proc_macro]
pub fn message(tokens: TokenStream) -> TokenStream {
    let id = parse_macro_input!(tokens as LitStr);
    let missing = texts::wanted(texts::english(), &id.value()).err();
    let fault = missing.map(|missing| syn::Error::new(id.span(), missing).into_compile_error());
    quote!({ #fault ::fitcheck_core::message::Message::new(#id) }).into()
}

/// Gives a type its texts; see the crate's documentation.
#[proc_macro_derive(Say, attributes(say, from))]
pub fn derive_say(tokens: TokenStream) -> TokenStream {
    let input = parse_macro_input!(tokens as DeriveInput);
    input::Said::read(&input)
        .map_or_else(syn::Error::into_compile_error, |said| output::write(&said, texts::english()))
        .into()
}
