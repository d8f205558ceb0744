// Names, units and numbers as people write them.

/** A unit of UDUNITS as people write it: 'cmH2O s L-1' is cmH₂O s/L. */
const units = { percent: '%', 1: '' };
export const unitText = (unit) => units[unit] ?? (unit ?? '').replace(/ (\S+)-1$/, '/$1').replaceAll('cmH2O', 'cmH₂O');
export const withUnit = (name, unit) => (unitText(unit) ? `${name} (${unitText(unit)})` : name);

const names = {
  delta_v_ml: 'ΔV, tidal volume',
  delta_v_percent: 'ΔV of end-expiratory volume',
  end_expiratory_volume_ml: 'end-expiratory volume',
  end_inspiratory_volume_ml: 'end-inspiratory volume',
  delta_l_mm: 'ΔL, zone of apposition shortens',
  delta_l_percent: 'ΔL of its rest length',
  delta_h_mm: 'ΔH, domes flatten',
  delta_r_mm: 'ΔR, zone of apposition widens',
  excursion_left_mm: 'left dome descends',
  excursion_right_mm: 'right dome descends',
  max_relative_volume_error: 'largest relative error of the abdominal volume',
  flipped_triangles: 'lung triangles turned over',
  abdominal_pressure_peak_cmH2O: 'peak abdominal pressure',
  end_expiratory_above_relaxation_ml: 'end-expiratory volume above relaxation',
  gastric_swing_cmH2O: 'swing of the gastric pressure',
  pleural_swing_cmH2O: 'swing of the pleural pressure',
  transdiaphragmatic_swing_cmH2O: 'swing of the transdiaphragmatic pressure',
  excursion_right_most_risen_mm: 'right dome, where it is most risen',
  excursion_left_most_risen_mm: 'left dome, where it is most risen',
  abdominal_elastance_cmH2O_per_L: 'abdominal elastance',
  lung_elastance_cmH2O_per_L: 'lung elastance',
  respiratory_elastance_cmH2O_per_L: 'respiratory elastance',
  resistance_cmH2O_s_per_L: 'resistance of airway and lung',
  intrinsic_peep_cmH2O: 'intrinsic PEEP',
  work_of_breathing_J_per_L: 'inspiratory work of breathing, a litre',
  work_of_breathing_J_per_min: 'inspiratory work of breathing, a minute',
  elastic_work_J_per_L: 'elastic work, a litre',
  resistive_work_J_per_L: 'resistive work, a litre',
  intrinsic_peep_work_J_per_L: 'work against intrinsic PEEP, a litre',
  chest_wall_work_J_per_L: 'work on the chest wall, a litre',
  expiratory_resistive_work_J_per_L: 'expiratory resistive work, a litre',
  pressure_time_product_pleural_cmH2O_s: 'pressure–time product, pleural, a breath',
  pressure_time_product_pleural_cmH2O_s_per_min: 'pressure–time product, pleural, a minute',
  pressure_time_product_transdiaphragmatic_cmH2O_s: 'pressure–time product, transdiaphragmatic, a breath',
  pressure_time_product_transdiaphragmatic_cmH2O_s_per_min: 'pressure–time product, transdiaphragmatic, a minute',
  tension_time_index: 'tension–time index',
  tension_time_cmH2O: 'tension–time product, not divided by the maximum',
  dynamic_lung_compliance_ml_per_cmH2O: 'dynamic lung compliance',
  dynamic_lung_elastance_cmH2O_per_L: 'dynamic lung elastance',
  lung_resistance_cmH2O_s_per_L: 'lung resistance',
  r_ei: 'muscle against recoil at end-inspiration',
  recoil_time_s: 'recoil time',
  k_muscle_over_k_elasticity: 'muscle stiffness over tissue stiffness',
  k_elasticity: 'tissue stiffness, k_elasticity',
  k_muscle: 'muscle stiffness, k_muscle',
  nrmse_percent: 'residual (RMS of tidal volume)',
  baseline_nrmse_percent: 'the same of a one-compartment model',
  bic: 'BIC',
  baseline_bic: 'BIC of a one-compartment model',
  tidal_volume_measured_ml: 'measured tidal volume',
  tidal_volume_error_ml: 'error of the tidal volume',
  peak_time_error_s: 'error of the time of the peak',
  failed_evaluations: 'simulations that failed',
  methods_differ_percent: 'largest difference between the two search methods',
  noise_autocorrelation: 'autocorrelation of the noise',
  noise_sigma_ml: 'standard deviation of the noise',
  degrees_of_freedom: 'degrees of freedom',
  residual_autocorrelation: 'autocorrelation of the residual',
  condition_number: 'condition number',
  ratio: 'k_muscle / k_elasticity',
  ratio_lower95: 'k_muscle / k_elasticity, lower end of 95 %',
  ratio_upper95: 'k_muscle / k_elasticity, upper end of 95 %',
};

/** A name from a file in words: known ones in full, others with blanks. */
export const nameText = (name) => names[name] ?? name;

/** Short: for axes and heads of tables. */
export function shortName(name) {
  const bare = name.replace(/^parameters\./, '').replaceAll('.', ' ');
  return bare.replace(/_(N_per_m|N_s_per_m|ml|mm|percent|cmH2O|cmH2O_per_L|cmH2O_s(_per_(L|min))?|J_per_(L|min)|ml_per_cmH2O|s|ms|deg|kg|m_s2)$/, '').replace(/(?<!^k)_/g, ' ');
}

export const words = (name) => name.replaceAll('_', ' ');

/** A number to so many significant digits, with a true minus sign; "not known" where there is none. */
export function numberText(value, digits = 4) {
  if (value === null || value === undefined || !Number.isFinite(value)) return 'not known';
  if (value === 0) return '0';
  const size = Math.abs(value);
  const text =
    size >= 1e6 || size < 1e-4
      ? value.toExponential(Math.max(0, digits - 2))
      : Number(value.toPrecision(digits)).toLocaleString('en', { maximumSignificantDigits: digits, useGrouping: false });
  return text.replace('-', '−');
}

export const quantity = (value, unit, digits) => {
  const text = numberText(value, digits);
  return text === 'not known' || !unitText(unit) ? text : `${text} ${unitText(unit)}`;
};

/** With so many decimals, for readouts that change. */
export const fixed = (value, decimals) =>
  Number.isFinite(value) ? value.toFixed(decimals).replace('-', '−') : '–';
