// Names of parts and groups of entries, which the suite writes and the page reads.
#pragma once

#include <array>

namespace prehend::bench {

// Parts of the suite; also words of its command line.
inline constexpr const char* kKernels = "kernels";
inline constexpr const char* kTrials = "trials";
inline constexpr const char* kPlans = "plans";
inline constexpr const char* kTrade = "trade";
inline constexpr const char* kScaling = "scaling";
inline constexpr std::array<const char*, 5> kParts = {kKernels, kTrials, kPlans, kTrade, kScaling};

// Of kernels.
inline constexpr const char* kCall = "call";

// Of trials, by hand and object.
inline constexpr const char* kTrialTime = "trial in contact";
inline constexpr const char* kInContact = "ends in contact";  // part of all trials [%]
inline constexpr const char* kHolds = "holds";                // part of all trials [%]
inline constexpr const char* kTriedPerSecond = "trials a second";
inline constexpr const char* kHoldingPerSecond = "holding grasps a second";
// The stages of a trial, as groups "share of STAGE".
inline constexpr std::array<const char*, 6> kTrialStages = {"approach", "reach",    "closing",
                                                            "settling", "contacts", "quality"};
inline constexpr const char* kShareOf = "share of ";

// Of trials, by scene with an arm.
inline constexpr const char* kReach = "reach of a grasp";
inline constexpr const char* kPath = "path with its check";
inline constexpr const char* kPathCheck = "check of a path";
inline constexpr const char* kMotion = "duration of the motion";

// Of plans, by scene and options ("mug, draft"): runs of the program from its start to the last
// file, on one thread. Stages are those of run_context.h, as groups "time of STAGE".
inline constexpr const char* kRun = "whole run";
inline constexpr const char* kTimeOf = "time of ";

// Of trade, by object and setting ("mug, draft").
inline constexpr const char* kTimePerTrial = "time per trial";
inline constexpr const char* kEpsilonError = "error of epsilon";
inline constexpr const char* kOtherVerdict = "other verdict";
inline constexpr const char* kBestKept = "best 10 kept";
// The same, x is the number of trials of a plan.
inline constexpr const char* kPlanTime = "planning time";
inline constexpr const char* kBestEpsilon = "best epsilon";
// Series is the setting that a plan has by default, the value how many trials it makes.
inline constexpr const char* kDefault = "default";

// Of scaling; x is the size.
inline constexpr const char* kTriangles = "triangles";
inline constexpr const char* kCandidates = "candidates";
inline constexpr const char* kContacts = "contacts";
inline constexpr const char* kThreads = "threads";
inline constexpr const char* kObstacles = "obstacles";
inline constexpr std::array<const char*, 5> kSizes = {kTriangles, kCandidates, kContacts, kThreads,
                                                      kObstacles};

}  // namespace prehend::bench
