//! Enums whose variants all have a word: in files, on the command line, or on a drawing.

/// Declares an enum with a list of all its variants, in their order, and the word of each.
///
/// ```
/// fitcheck_core::named! {
///     /// A colour of a traffic light.
///     #[derive(Debug, Clone, Copy, PartialEq, Eq)]
///     pub enum Light {
///         /// Every colour, from above.
///         ALL;
///         /// The word in files.
///         fn word;
///         /// Stop.
///         Red = "red",
///         /// Go.
///         Green = "green",
///     }
/// }
///
/// assert_eq!(Light::ALL.map(Light::word), ["red", "green"]);
/// ```
#[macro_export]
macro_rules! named {
    (
        $(#[$meta:meta])*
        $vis:vis enum $Name:ident {
            $(#[$of_all:meta])* ALL;
            $(#[$of_word:meta])* fn $word:ident;
            $($(#[$of_variant:meta])* $Variant:ident = $text:literal,)+
        }
    ) => {
        $(#[$meta])*
        $vis enum $Name {
            $($(#[$of_variant])* $Variant,)+
        }

        impl $Name {
            $(#[$of_all])*
            $vis const ALL: [Self; [$($text),+].len()] = [$(Self::$Variant),+];

            $(#[$of_word])*
            $vis const fn $word(self) -> &'static str {
                match self {
                    $(Self::$Variant => $text,)+
                }
            }
        }
    };
}
