//! Scenes for the polhode engine: TOML files, mesh files, recordings.
