//! The generated code, and an error for every text that does not fit.

use proc_macro2::TokenStream;
use quote::{format_ident, quote};
use syn::{Ident, Member};

use crate::input::{Case, Said, Text};
use crate::texts::{Texts, wanted};

/// The impls are made even with errors: without them, every use of the type would be an error of its own.
pub(crate) fn write(said: &Said, texts: &Texts) -> TokenStream {
    let errors = said.cases.iter().filter_map(|case| {
        let message = wrong(case, texts)?;
        Some(syn::Error::new(case.span, message).into_compile_error())
    });
    let Said { name, generics, .. } = said;
    let (for_impl, for_type, conditions) = generics.split_for_impl();
    let arms = said.cases.iter().map(arm);
    let error = said.is_error.then(|| quote!(impl #for_impl ::std::error::Error for #name #for_type #conditions {}));
    let from = said.cases.iter().flat_map(|case| conversions(said, case));
    quote! {
        #(#errors)*
        #[automatically_derived]
        impl #for_impl ::fitcheck_core::message::Say for #name #for_type #conditions {
            fn message(&self) -> ::fitcheck_core::message::Message {
                match self { #(#arms)* }
            }
        }
        #[automatically_derived]
        impl #for_impl ::std::fmt::Display for #name #for_type #conditions {
            fn fmt(&self, f: &mut ::std::fmt::Formatter<'_>) -> ::std::fmt::Result {
                ::std::fmt::Display::fmt(&::fitcheck_core::message::Say::message(self), f)
            }
        }
        #error
        #(#from)*
    }
}

/// Why a case has no sentence: its text is missing, or asks for more than it is given.
fn wrong(case: &Case, texts: &Texts) -> Option<String> {
    let Text::Named(id) = &case.text else { return None };
    let wanted = match wanted(texts, id) {
        Ok(wanted) => wanted,
        Err(missing) => return Some(missing),
    };
    let fields = case.fields.iter().filter_map(|field| field.argument.as_ref());
    let given: Vec<&String> = fields.chain(case.computed.iter().map(|(name, _)| name)).collect();
    let missing = wanted.iter().find(|name| !given.contains(name))?;
    Some(format!("text {id} asks for ${missing}; given are {given:?}"))
}

fn binding(member: &Member) -> Ident {
    match member {
        Member::Named(name) => name.clone(),
        Member::Unnamed(index) => format_ident!("field_{}", index.index),
    }
}

fn arm(case: &Case) -> TokenStream {
    let path = case.variant.as_ref().map_or_else(|| quote!(Self), |variant| quote!(Self::#variant));
    let bindings = case.fields.iter().map(|field| {
        let member = &field.member;
        let name = binding(member);
        // A field that no argument asks for may still be used by a computed value.
        let is_used = field.argument.is_some() || matches!(case.text, Text::Transparent) || !case.computed.is_empty();
        match member {
            Member::Named(_) if is_used => quote!(#name,),
            Member::Unnamed(_) if is_used => quote!(#member: #name,),
            _ => quote!(#member: _,),
        }
    });
    let pattern = quote!(#path { #(#bindings)* });
    let Text::Named(id) = &case.text else {
        let inner = case.fields.iter().map(|field| binding(&field.member));
        return quote!(#pattern => ::fitcheck_core::message::Say::message(#(#inner)*),);
    };
    let arguments = case.fields.iter().filter_map(|field| {
        let argument = field.argument.as_ref()?;
        let name = binding(&field.member);
        Some(if let Some(with) = &field.with {
            quote!(.with(#argument, &#with(#name)))
        } else {
            quote!(.with(#argument, #name))
        })
    });
    let computed = case.computed.iter().map(|(name, expression)| quote!(.with(#name, &(#expression))));
    let unused = (!case.computed.is_empty()).then(|| {
        let names = case.fields.iter().filter(|field| field.argument.is_none()).map(|field| binding(&field.member));
        quote!(#(let _ = #names;)*)
    });
    quote!(#pattern => { #unused ::fitcheck_core::message::Message::new(#id) #(#arguments)* #(#computed)* })
}

fn conversions<'a>(said: &'a Said, case: &'a Case) -> impl Iterator<Item = TokenStream> + 'a {
    let (for_impl, for_type, conditions) = said.generics.split_for_impl();
    let name = &said.name;
    case.fields.iter().filter(|field| field.is_from).map(move |field| {
        let ty = &field.ty;
        let member = &field.member;
        let path = case.variant.as_ref().map_or_else(|| quote!(Self), |variant| quote!(Self::#variant));
        quote! {
            impl #for_impl ::std::convert::From<#ty> for #name #for_type #conditions {
                fn from(from: #ty) -> Self {
                    #path { #member: from }
                }
            }
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What is made from a type, given that English has these texts, and the errors in it.
    fn made(source: &str) -> (String, usize) {
        let texts = ["shape-round", "shape-square"].map(|id| (id.to_owned(), ["side".to_owned()].into()));
        let said = Said::read(&syn::parse_str(source).unwrap()).unwrap();
        let code = write(&said, &Ok(texts.into())).to_string();
        let errors = code.matches("compile_error").count();
        (code, errors)
    }

    const IMPLS: [&str; 4] = [
        "impl :: fitcheck_core :: message :: Say for Shape",
        "impl :: std :: fmt :: Display for Shape",
        "impl :: std :: error :: Error for Shape",
        "impl :: std :: convert :: From < u8 > for Shape",
    ];

    #[track_caller]
    fn check(variants: &str, errors: &[&str]) {
        let (code, count) = made(&format!("#[say(prefix = \"shape\", error)] enum Shape {{ {variants} }}"));
        assert_eq!(count, errors.len(), "{code}");
        for text in errors.iter().chain(&IMPLS) {
            assert!(code.contains(text), "{text} is missing in {code}");
        }
    }

    #[test]
    fn texts_that_fit_make_no_error() {
        check("Round { side: u8 }, Square(#[from] #[say(name = \"side\")] u8)", &[]);
    }

    #[test]
    fn a_missing_text_or_argument_is_one_error_and_the_impls_are_there() {
        check("Round { side: u8 }, Oval(#[from] u8)", &["assets/locales/en has no text shape-oval"]);
        check("Round { edge: u8 }, Square(#[from] #[say(name = \"side\")] u8)", &["text shape-round asks for $side"]);
    }

    #[test]
    fn two_wrong_variants_are_two_errors() {
        check("Round(#[from] u8), Oval", &["asks for $side", "has no text shape-oval"]);
    }
}
