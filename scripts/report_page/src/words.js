// Names, units and numbers as people write them.

const units = { 'N m-1': 'N/m', 'N s m-1': 'N s/m', percent: '%', 1: '', cmH2O: 'cmH₂O', 'm s-1': 'm/s' };
export const unitText = (unit) => units[unit] ?? unit ?? '';
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
  return bare.replace(/_(N_per_m|N_s_per_m|ml|mm|percent|cmH2O|s|ms|deg|kg|m_s2)$/, '').replace(/(?<!^k)_/g, ' ');
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
