//! Occupancy grid, signed distance field, object circles and ROS maps.
