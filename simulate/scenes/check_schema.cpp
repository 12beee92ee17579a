// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/scenes/check_schema.h"

#include <set>
#include <string>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>
#include <vector>

namespace pcm::simulate {
namespace {

using Json = nlohmann::json;

/// valijson's path, <root> [bodies] [0], as a pointer.
std::string pointer_from(const std::vector<std::string>& context) {
  std::string pointer;
  for (std::size_t i = 1; i < context.size(); ++i) {
    Json::json_pointer token;
    token /= context[i].substr(1, context[i].size() - 2);
    pointer += token.to_string();
  }
  return pointer;
}

/// The words that the schema allows a key anywhere.
void collect_words(const Json& schema, const std::string& key, std::set<std::string>& words) {
  if (!schema.is_structured()) return;
  if (schema.is_object() && schema.contains("properties") && schema["properties"].contains(key)) {
    const Json& property = schema["properties"][key];
    if (property.contains("enum"))
      for (const Json& word : property["enum"]) words.insert(word.get<std::string>());
  }
  for (const Json& part : schema) collect_words(part, key, words);
}

/// In our words where theirs tell too little.
std::string told(const std::string& description, const std::string& pointer, const Json& schema) {
  const std::string unknown =
      "Object contains a property that could not be validated using 'properties' or "
      "'additionalProperties' constraints: '";
  if (description.rfind(unknown, 0) == 0) return std::string("unknown key '").append(description, unknown.size());
  const std::string missing = "Missing required property '";
  if (description.rfind(missing, 0) == 0) {
    const std::size_t end = description.find('\'', missing.size());
    return std::string("the key '").append(description, missing.size(), end - missing.size()).append("' is missing");
  }
  if (description.find("enum") != std::string::npos) {
    std::set<std::string> words;
    collect_words(schema, pointer.substr(pointer.rfind('/') + 1), words);
    std::string list;
    for (const std::string& word : words) list += (list.empty() ? "" : ", ") + word;
    return std::string("it must be one of: ").append(list);
  }
  if (description == "Value type not permitted by 'type' constraint.")
    return "a value of this type is not allowed here";
  return description;
}

}  // namespace

void check_schema(const LocatedJson& json, std::string_view schema_text) {
  const Json schema_json = Json::parse(schema_text);
  valijson::Schema schema;
  const valijson::adapters::NlohmannJsonAdapter schema_adapter(schema_json);
  valijson::SchemaParser().populateSchema(schema_adapter, schema);
  valijson::ValidationResults results;
  valijson::Validator validator;
  const valijson::adapters::NlohmannJsonAdapter document(json.document());
  if (validator.validate(schema, document, &results)) return;
  // The innermost one comes first.
  valijson::ValidationResults::Error error;
  results.popError(error);
  const std::string pointer = pointer_from(error.context);
  json.refuse(pointer, told(error.description, pointer, schema_json));
}

}  // namespace pcm::simulate
