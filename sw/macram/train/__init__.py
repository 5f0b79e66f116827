"""Training: targets, losses, augmentation, stages."""
