//! The code that is made, after the texts were found to fit.

use proc_macro2::TokenStream;
use quote::{format_ident, quote};
use syn::{Ident, Member};

use crate::input::{Case, Said, Text};
use crate::texts;

pub(crate) fn write(said: &Said) -> syn::Result<TokenStream> {
    for case in &said.cases {
        check(case)?;
    }
    let Said { name, generics, .. } = said;
    let (for_impl, for_type, conditions) = generics.split_for_impl();
    let arms = said.cases.iter().map(arm);
    let error = said.is_error.then(|| quote!(impl #for_impl ::std::error::Error for #name #for_type #conditions {}));
    let from = said.cases.iter().flat_map(|case| conversions(said, case));
    Ok(quote! {
        #[automatically_derived]
        impl #for_impl crate::message::Say for #name #for_type #conditions {
            fn message(&self) -> crate::message::Message {
                match self { #(#arms)* }
            }
        }
        #[automatically_derived]
        impl #for_impl ::std::fmt::Display for #name #for_type #conditions {
            fn fmt(&self, f: &mut ::std::fmt::Formatter<'_>) -> ::std::fmt::Result {
                ::std::fmt::Display::fmt(&crate::message::Say::message(self), f)
            }
        }
        #error
        #(#from)*
    })
}

/// The text is there, and gets all that it asks for.
fn check(case: &Case) -> syn::Result<()> {
    let refuse = |message: String| Err(syn::Error::new(case.span, message));
    let Text::Named(id) = &case.text else { return Ok(()) };
    let texts = match texts::english() {
        Ok(texts) => texts,
        Err(error) => return refuse(format!("the English texts cannot be read: {error}")),
    };
    let Some(wanted) = texts.get(id) else { return refuse(format!("assets/locales/en has no text {id}")) };
    let fields = case.fields.iter().filter_map(|field| field.argument.as_ref());
    let given: Vec<&String> = fields.chain(case.computed.iter().map(|(name, _)| name)).collect();
    match wanted.iter().find(|name| !given.contains(name)) {
        Some(name) => refuse(format!("text {id} asks for ${name}; given are {given:?}")),
        None => Ok(()),
    }
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
        let (member, name) = (&field.member, binding(&field.member));
        // A field that no argument asks for may still be used by a computed one.
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
        return quote!(#pattern => crate::message::Say::message(#(#inner)*),);
    };
    let arguments = case.fields.iter().filter_map(|field| {
        let (argument, name) = (field.argument.as_ref()?, binding(&field.member));
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
    quote!(#pattern => { #unused crate::message::Message::new(#id) #(#arguments)* #(#computed)* })
}

fn conversions<'a>(said: &'a Said, case: &'a Case) -> impl Iterator<Item = TokenStream> + 'a {
    let (for_impl, for_type, conditions) = said.generics.split_for_impl();
    let name = &said.name;
    case.fields.iter().filter(|field| field.is_from).map(move |field| {
        let (ty, member) = (&field.ty, &field.member);
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
