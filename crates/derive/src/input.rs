//! What the source declares: the type, its variants, and the attributes.

use proc_macro2::Span;
use syn::ext::IdentExt as _;
use syn::parse::ParseStream;
use syn::{Attribute, Data, DeriveInput, Expr, Fields, Generics, Ident, LitStr, Member, Path, Token, Type};

use crate::texts::kebab;

/// A type with texts.
pub(crate) struct Said {
    pub(crate) name: Ident,
    pub(crate) generics: Generics,
    pub(crate) is_error: bool,
    pub(crate) cases: Vec<Case>,
}

/// A variant, or the one shape of a struct.
pub(crate) struct Case {
    /// `None` for a struct.
    pub(crate) variant: Option<Ident>,
    pub(crate) span: Span,
    pub(crate) text: Text,
    pub(crate) fields: Vec<Field>,
    pub(crate) computed: Vec<(String, Expr)>,
}

/// Where a case's text comes from.
pub(crate) enum Text {
    Named(String),
    /// What its only field says.
    Transparent,
}

/// A field of a case.
pub(crate) struct Field {
    pub(crate) member: Member,
    pub(crate) ty: Type,
    /// The name of its argument; `None` where it is left out.
    pub(crate) argument: Option<String>,
    pub(crate) with: Option<Path>,
    pub(crate) is_from: bool,
}

/// What `#[say(…)]` may hold.
#[derive(Default)]
struct Attributes {
    prefix: Option<String>,
    id: Option<String>,
    name: Option<String>,
    with: Option<Path>,
    is_error: bool,
    is_transparent: bool,
    is_skipped: bool,
    computed: Vec<(String, Expr)>,
}

impl Attributes {
    fn read(attributes: &[Attribute]) -> syn::Result<Self> {
        let mut read = Self::default();
        for attribute in attributes.iter().filter(|attribute| attribute.path().is_ident("say")) {
            attribute.parse_nested_meta(|meta| {
                let text = || meta.value()?.parse::<LitStr>().map(|text| Some(text.value()));
                match meta.path.get_ident().map(ToString::to_string).as_deref() {
                    Some("prefix") => read.prefix = text()?,
                    Some("id") => read.id = text()?,
                    Some("name") => read.name = text()?,
                    Some("with") => read.with = Some(meta.value()?.parse()?),
                    Some("error") => read.is_error = true,
                    Some("transparent") => read.is_transparent = true,
                    Some("skip") => read.is_skipped = true,
                    Some("args") => {
                        let inner;
                        syn::parenthesized!(inner in meta.input);
                        read.computed.extend(inner.parse_terminated(argument, Token![,])?);
                    }
                    _ => return Err(meta.error("expected prefix, id, name, with, args, error, transparent or skip")),
                }
                Ok(())
            })?;
        }
        Ok(read)
    }
}

fn argument(input: ParseStream<'_>) -> syn::Result<(String, Expr)> {
    let name = input.call(Ident::parse_any)?;
    input.parse::<Token![=]>()?;
    Ok((kebab(&name.to_string()), input.parse()?))
}

impl Said {
    pub(crate) fn read(input: &DeriveInput) -> syn::Result<Self> {
        let own = Attributes::read(&input.attrs)?;
        let cases = match &input.data {
            Data::Enum(data) => {
                let cases = data.variants.iter().map(|variant| {
                    let attributes = Attributes::read(&variant.attrs)?;
                    let named = || {
                        let prefix = own.prefix.as_ref()?;
                        Some(format!("{prefix}-{}", kebab(&variant.ident.to_string())))
                    };
                    Case::read(Some(variant.ident.clone()), variant.ident.span(), attributes, named, &variant.fields)
                });
                cases.collect::<syn::Result<_>>()?
            }
            Data::Struct(data) => {
                let attributes = Attributes { is_error: false, ..Attributes::read(&input.attrs)? };
                vec![Case::read(None, input.ident.span(), attributes, || None, &data.fields)?]
            }
            Data::Union(_) => return Err(syn::Error::new(input.ident.span(), "a union says nothing")),
        };
        Ok(Self { name: input.ident.clone(), generics: input.generics.clone(), is_error: own.is_error, cases })
    }
}

impl Case {
    fn read(
        variant: Option<Ident>,
        span: Span,
        attributes: Attributes,
        named: impl FnOnce() -> Option<String>,
        fields: &Fields,
    ) -> syn::Result<Self> {
        let read = fields.members().zip(fields).map(|(member, field)| {
            let own = Attributes::read(&field.attrs)?;
            let by_place = || match &member {
                Member::Named(name) => kebab(&name.to_string()),
                Member::Unnamed(_) => "value".to_owned(),
            };
            let argument = (!own.is_skipped && !attributes.is_transparent).then(|| own.name.unwrap_or_else(by_place));
            let is_from = field.attrs.iter().any(|attribute| attribute.path().is_ident("from"));
            Ok(Field { member, ty: field.ty.clone(), argument, with: own.with, is_from })
        });
        let fields: Vec<Field> = read.collect::<syn::Result<_>>()?;
        let text = if attributes.is_transparent {
            if fields.len() != 1 {
                return Err(syn::Error::new(span, "transparent needs exactly one field"));
            }
            Text::Transparent
        } else {
            let id = attributes.id.or_else(named);
            Text::Named(id.ok_or_else(|| syn::Error::new(span, "say(prefix) on the enum or say(id) here is missing"))?)
        };
        Ok(Self { variant, span, text, fields, computed: attributes.computed })
    }
}
