use super::recording::RECORDING_NAME;
use super::topics::{self, Topic};
use std::collections::BTreeMap;

/// rosbag2's `metadata.yaml`, version 5, for messages by topic over `duration` nanoseconds from 0.
pub(super) fn yaml(counts: &BTreeMap<&'static str, u32>, duration: u64) -> String {
    let count = |topic: &Topic| counts.get(topic.name).copied().unwrap_or(0);
    let total: u32 = topics::ALL.iter().map(count).sum();
    let mut text = format!(
        "rosbag2_bagfile_information:
  version: 5
  storage_identifier: mcap
  duration:
    nanoseconds: {duration}
  starting_time:
    nanoseconds_since_epoch: 0
  message_count: {total}
  topics_with_message_count:
"
    );
    for topic in &topics::ALL {
        text += &format!(
            "    - topic_metadata:
        name: {}
        type: {}
        serialization_format: cdr
        offered_qos_profiles: \"{}\"
      message_count: {}
",
            topic.name,
            topic.message,
            topic.qos().replace('\n', "\\n"),
            count(topic)
        );
    }
    text += &format!(
        "  compression_format: \"\"
  compression_mode: \"\"
  relative_file_paths:
    - {RECORDING_NAME}
  files:
    - path: {RECORDING_NAME}
      starting_time:
        nanoseconds_since_epoch: 0
      duration:
        nanoseconds: {duration}
      message_count: {total}
"
    );
    text
}
