#include "report/sweep_pictures.hpp"
namespace tribo::report { std::vector<std::string> draw_sweep_pictures(const sweep::SweepResult&,const std::string&,const std::string&,const std::function<void(std::string_view)>&){return {};} }
