//! Where records are kept, at the edge: an embedded file for each station, and the server of a shop.
//!
//! | file | what |
//! |---|---|
//! | `shop` | the PostgreSQL server of a shop, with the feature of that name |
