mod import;
mod logs;
