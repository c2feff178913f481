// Chapter 8's sphere of L under a title of its own.
tumble_live.figures.engine_rules = {
  ...tumble_live.figures.energy_sphere,
  title: 'A stable spin, turned by an engine’s rule',
};
