#pragma once
// The maintenance of an installation as its project states it, the basis of its maintenance
// factors. No light or verdict depends on it.

#include <array>
#include <optional>
#include <string>

namespace calc {

struct MaintenancePlan {
  std::string environment, instructions;  // in the project's words; "" = not stated
  // Months between cleanings, hours until light sources are replaced, hours of use in a year.
  std::optional<double> clean_luminaires_months, clean_surfaces_months, replace_lights_h, use_h;

  inline bool is_empty() const;
};

// The numbers with their names in projects and results, in the order in which reports show them.
struct MaintenanceNumber {
  const char* name;  // of the attribute
  const char* result_key;
  std::optional<double> MaintenancePlan::*number;
};
inline constexpr std::array kMaintenanceNumbers{
    MaintenanceNumber{"clean-luminaires-months", "clean_luminaires_months",
                      &MaintenancePlan::clean_luminaires_months},
    MaintenanceNumber{"clean-surfaces-months", "clean_surfaces_months",
                      &MaintenancePlan::clean_surfaces_months},
    MaintenanceNumber{"replace-lights-hours", "replace_lights_h",
                      &MaintenancePlan::replace_lights_h},
    MaintenanceNumber{"hours-in-a-year", "use_h", &MaintenancePlan::use_h}};

bool MaintenancePlan::is_empty() const {
  for (const MaintenanceNumber& one : kMaintenanceNumbers) {
    if (this->*one.number) return false;
  }
  return environment.empty() && instructions.empty();
}

}  // namespace calc
