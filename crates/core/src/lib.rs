//! Whether a probed hole or shaft is good, rework or scrap, and why: limits of size, measuring cycles and verdicts.
//!
//! This is what Fitcheck computes with: all of ISO 286, the general tolerances of ISO 2768, decision rules after
//! ISO 14253-1 and others, circles through contacts, measuring cycles, uncertainty budgets and plans of parts. Data goes
//! one way, from a callout to a verdict. Nothing here reads a file, starts a thread or asks for the time; what is not
//! defined is refused with a reason.
//!
//! | module | what |
//! |---|---|
//! | [`length`] | whole nanometres: sizes, deviations and limits compare exactly |
//! | [`tolerance`] | callouts, classes, limits, fits as geometry |
//! | [`verdict`] | good, rework, scrap; decision rules |
//! | [`pairing`] | which measured holes go with which measured shafts |
//! | [`probing`] | contacts, circles, measuring cycles, the simulated workpiece |
//! | [`budget`] | how sure a measured value is |
//! | [`part`] | whole parts: plans of features |
//! | [`law`] | the laws of errors and of test statistics |
//! | [`message`], [`words`] | sentences without a language; texts in the user's language |
//! | [`text`] | from the bytes of a text file to text and lines |
//!
//! # Limits of a callout
//!
//! The letter's case says hole or shaft, as on the drawing. Every limit says where it comes from.
//!
//! ```
//! use fitcheck_core::tolerance::{Feature, Sources};
//!
//! let limits = Sources::default().limits(&"25 H7".parse()?, None)?;
//! assert_eq!(limits.minimum().to_string(), "25");
//! assert_eq!(limits.maximum().to_string(), "25.021");
//! assert_eq!(limits.feature, Some(Feature::Hole));
//! assert_eq!(limits.source.to_string(), "ISO 286, over 18 up to 30 mm");
//!
//! // No class at this size is an error with a reason, never a guess.
//! assert!(Sources::default().limits(&"4000 H7".parse()?, None).is_err());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # A verdict, with and without a decision rule
//!
//! Limits belong to the zone. A rule with an uncertainty keeps a guard band free on either side of a limit: there,
//! nothing is decided.
//!
//! ```
//! use fitcheck_core::tolerance::Sources;
//! use fitcheck_core::verdict::rules::{RuleInputs, RuleName, Uncertainty};
//! use fitcheck_core::verdict::{Rule, Status, judge_size};
//!
//! let limits = Sources::default().limits(&"25 H7".parse()?, None)?;
//! let measured = "25.020".parse()?;
//! assert_eq!(judge_size(&limits, measured).status, Status::Good);
//!
//! // A standard uncertainty of 2 µm: 1.65 × 2 µm of guard band, after ISO 14253-1:2017.
//! let given = RuleInputs { uncertainty: Some(Uncertainty::standard("2")?), ..RuleInputs::default() };
//! let rule = Rule::new(RuleName::Iso14253Of2017, given)?;
//! assert_eq!(rule.status(&limits.bounds(), measured), Status::ReMeasure);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # A circle through contacts
//!
//! Contacts are in millimetres. Every criterion of ISO 14405-1 is evaluated, and what the contacts cannot tell is said.
//!
//! ```
//! use fitcheck_core::probing::Contact;
//! use fitcheck_core::probing::circle::evaluate;
//!
//! let contacts = [(62.5, 50.0), (50.0, 62.5), (37.5, 50.0), (50.0, 37.5)].map(|(x, y)| Contact { x, y, z: -5.0 });
//! let found = evaluate(&contacts)?;
//! assert!((found.least_squares.diameter - 25.0).abs() < 1e-12);
//! assert!(found.form() < 1e-12);
//! // Four contacts show little of the form.
//! assert!(!found.warnings.is_empty());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

#![warn(missing_docs)]

// What is derived names the types of this crate by its name, here as elsewhere.
extern crate self as fitcheck_core;

pub mod budget;
pub mod law;
pub mod length;
pub mod message;
pub mod pairing;
pub mod part;
pub mod probing;
pub mod text;
pub mod tolerance;
pub mod verdict;
pub mod words;
