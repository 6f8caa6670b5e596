"""Pictures of the runs of tools/truthcube: what a run's files hold, and plots of them, one module each."""
