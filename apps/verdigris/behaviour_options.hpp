#pragma once
// The options of a command that runs a behaviour, and how they become a scene.

#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "options.hpp"
#include "verdigris/automaton/catalogue.hpp"
#include "verdigris/io/scene.hpp"

/// What a user gives, as text where it has to be understood first.
struct BehaviourOptions {
  verdigris::Scene scene;
  RunOptions run;
  SurfaceOptionTexts surface;
  PictureOptionTexts picture;
  std::string mesh, torus, seeds, mask;
  std::map<std::string, std::string> parameters;
};

/// MODEL, seeds, surface, the behaviour's parameters but those `without`, barrier, steps, picture and run.
void add_behaviour_options(CLI::App& command, const std::shared_ptr<BehaviourOptions>& options,
                           const verdigris::BehaviourEntry& entry,
                           std::span<const std::string_view> without = {});

/// Completes the scene. Throws InputError.
void finish_behaviour_options(BehaviourOptions& options, const verdigris::BehaviourEntry& entry);
