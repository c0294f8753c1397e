//! The container: channels, sequence numbers, messages in CDR.

use super::contents::{nanoseconds, odometry, torques, transform};
use super::messages::{TfMessage, Time};
use super::metadata;
use super::recording::{RecordingError, RecordingFiles};
use super::topics::{self, Topic};
use byteorder::LittleEndian;
use mcap::records::MessageHeader;
use mcap::{WriteOptions, Writer};
use pairtrawl_geometry::Pose;
use pairtrawl_model::ControlSample;
use serde::Serialize;
use std::collections::BTreeMap;
use std::io::Cursor;

/// The container under construction.
pub(super) struct Bag {
    writer: Writer<Cursor<Vec<u8>>>,
    channels: BTreeMap<&'static str, u16>,
    counts: BTreeMap<&'static str, u32>,
    last: u64,
}

impl Bag {
    pub fn new() -> Result<Self, RecordingError> {
        let options = WriteOptions::new()
            .compression(None)
            .profile("ros2")
            .library("pairtrawl");
        let mut writer = options.create(Cursor::new(Vec::new()))?;
        let mut channels = BTreeMap::new();
        for topic in topics::ALL {
            let schema =
                writer.add_schema(topic.message, "ros2msg", topic.definition.as_bytes())?;
            let metadata =
                BTreeMap::from([("offered_qos_profiles".to_owned(), topic.qos().to_owned())]);
            channels.insert(
                topic.name,
                writer.add_channel(schema, topic.name, "cdr", &metadata)?,
            );
        }
        Ok(Self {
            writer,
            channels,
            counts: BTreeMap::new(),
            last: 0,
        })
    }

    pub fn send(
        &mut self,
        topic: Topic,
        time: u64,
        message: &impl Serialize,
    ) -> Result<(), RecordingError> {
        let fault = |reason: String| RecordingError::Message {
            topic: topic.name,
            reason,
        };
        let body =
            cdr_encoding::to_vec::<_, LittleEndian>(message).map_err(|e| fault(e.to_string()))?;
        // The encapsulation header: plain CDR, little endian.
        let mut data = vec![0, 1, 0, 0];
        data.extend(body);
        let channel_id = *self
            .channels
            .get(topic.name)
            .ok_or_else(|| fault("it has no channel".to_owned()))?;
        let sequence = self.counts.entry(topic.name).or_default();
        *sequence += 1;
        let header = MessageHeader {
            channel_id,
            sequence: *sequence,
            log_time: time,
            publish_time: time,
        };
        self.writer.write_to_known_channel(&header, &data)?;
        self.last = self.last.max(time);
        Ok(())
    }

    pub fn send_sample(&mut self, sample: &ControlSample) -> Result<(), RecordingError> {
        let time = nanoseconds(sample.time);
        let stamp = Time::from_nanoseconds(time);
        let poses = [sample.robots.left, sample.robots.right];
        let mut transforms = Vec::with_capacity(4);
        for (side, name) in ["left", "right"].into_iter().enumerate() {
            let (odom, base) = (format!("{name}/odom"), format!("{name}/base_link"));
            let twist = (sample.forward[side], sample.turn_rate[side]);
            self.send(
                topics::ODOM[side],
                time,
                &odometry(stamp, &odom, &base, poses[side], twist),
            )?;
            self.send(topics::TORQUE[side], time, &torques(sample.torque[side]))?;
            transforms.push(transform(stamp, "map", &odom, Pose::default()));
            transforms.push(transform(stamp, &odom, &base, poses[side]));
        }
        self.send(topics::FRAMES, time, &TfMessage { transforms })
    }

    pub fn finish(mut self) -> Result<RecordingFiles, RecordingError> {
        self.writer.finish()?;
        let metadata = metadata::yaml(&self.counts, self.last);
        Ok(RecordingFiles {
            mcap: self.writer.into_inner().into_inner(),
            metadata,
        })
    }
}
