"""Between the engine and Qt: polling, background jobs, errors, settings."""
