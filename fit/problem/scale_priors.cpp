#include "problem/scale_priors.hpp"

namespace trunk {

std::vector<ScalePrior> scale_priors(const Parameters<double>& p, bool lung) {
  const char* judgement = "around the scenario's value (our choice)";
  std::vector<ScalePrior> all = {
      {std::string(abdominal_elastance_prior), "cmH2O/L", 7.0, 1.4,
       "a gastric rise of 3.7 (SD 1.1) cmH2O when a ventilator gives 0.6 L to patients"},
      {"damping", "N s/m", 14.5, 1.6, "that of the shipped healthy trunk (our choice)"},
      {"abdomen_stiffness_factor", "1", p.abdomen_factor, 1.6, judgement}};
  if (!lung) return all;
  all.push_back({"lung_elastance", "cmH2O/L", 5.0, 1.5,
                 "200 ml/cmH2O; the dynamic compliance of healthy men is 2.91 (SD 1.08) L/kPa"});
  all.push_back({"resistance", "cmH2O s/L", 2.5, 1.5,
                 "plethysmograph 1.5 (0.6 to 2.4); interrupter 0.38 (SD 0.17) kPa s/L, n = 172, Respiration "
                 "1994"});
  return all;
}

}  // namespace trunk
